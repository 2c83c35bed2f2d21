#pragma once

#include "field/terrain.h"

namespace cydonia::statistics {

// Values over a square window of 2 radius + 1 samples a side around each sample (Saunders
// 2006, section V.3.3.3), cut off at the field's sides. The time does not grow with the
// radius.
struct Windowed {
    Field<float> mean, deviation;  // metres
    Field<float> low, high;        // metres
    Field<float> east, north;      // mean gradient, rise over run
};
Windowed windowed(const Terrain& terrain, int radius);

Field<float> window_mean(const Field<float>& field, int radius);
Field<float> window_low(const Field<float>& field, int radius);
Field<float> window_high(const Field<float>& field, int radius);

}  // namespace cydonia::statistics
