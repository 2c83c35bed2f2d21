#pragma once

#include "field/terrain.h"

namespace cydonia::genetic {

// Of the square of 2 radius + 1 samples a side about each sample (Saunders 2006, section
// V.3.3.3), as far as it lies in the field. Each takes a time that does not grow with the
// radius.
struct Windowed {
    Field<float> mean, deviation;  // metres
    Field<float> low, high;        // metres
    Field<float> east, north;      // mean gradient: metres up per metre that way
};
Windowed windowed(const Terrain& terrain, int radius);

Field<float> window_mean(const Field<float>& field, int radius);
Field<float> window_low(const Field<float>& field, int radius);
Field<float> window_high(const Field<float>& field, int radius);

}  // namespace cydonia::genetic
