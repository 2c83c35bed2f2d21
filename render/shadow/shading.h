#pragma once

#include "field/field.h"
#include "field/sun.h"

namespace cydonia::render {

// Lambert shading: the share of the sun's light that falls on every sample, 0 to 1, as if
// nothing cast a shadow. Slopes from the neighbours on both sides; metres.
Field<float> shading(const Field<float>& heights, double spacing, const Sun& sun);

}  // namespace cydonia::render
