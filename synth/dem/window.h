#pragma once

#include "field/field.h"

namespace cydonia::dem {

// Where samples are taken from a model, in cells of it: its north-west corner is (0, 0),
// y grows south.
struct Window {
    double west = 0.0, north = 0.0;  // of the window's own corner
    double cell = 1.0;               // side of one of its samples
};

// width x height samples of the model: cubic between its cells (Keys 1981, a = -1/2) and,
// where a sample spans several, the same curve stretched over them. Samples that lie on
// the model's own are those to the last bit. Beyond the model its outermost heights.
Field<float> sampled(const Field<float>& model, const Window& window, int width,
                     int height);

}  // namespace cydonia::dem
