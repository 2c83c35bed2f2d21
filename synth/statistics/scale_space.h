#pragma once

#include <vector>

#include "field/field.h"

namespace cydonia::statistics {

// A field blurred by a Gaussian.
struct Scale {
    double deviation;   // samples; its square is t
    Field<float> land;  // L
};

// The cube of Saunders 2006, section III.3.2.2, step 1, which all detectors share.
// Deviations start at one sample and grow by sqrt(2), so that t doubles, up to 16 samples
// or an eighth of the shorter side.
std::vector<Scale> scale_space(const Field<float>& field);

// The deviation in samples at a position among the scales, which may lie between two.
double deviation_at(double place);

// The field blurred by a deviation in samples. It is mirrored beyond its sides.
Field<float> blurred(const Field<float>& field, double deviation);

}  // namespace cydonia::statistics
