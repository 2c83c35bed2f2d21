#pragma once

#include <vector>

#include "field/field.h"

namespace cydonia::genetic {

// A field as it is when seen so blurred.
struct Scale {
    double deviation;   // samples; its square is t
    Field<float> land;  // L
};

// The cube of Saunders 2006, section III.3.2.2, step 1, that all detectors share: from a
// deviation of one sample on, each sqrt(2) times as blurred as the one before, so that t
// doubles; up to 16 samples or an eighth of the shorter side.
std::vector<Scale> scale_space(const Field<float>& field);

// The deviation, in samples, at a place among the scales; between two of them a fraction.
double deviation_at(double place);

// Mirrored beyond the sides. `deviation` in samples.
Field<float> blurred(const Field<float>& field, double deviation);

}  // namespace cydonia::genetic
