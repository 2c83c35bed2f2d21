#pragma once

#include "field/field.h"
#include "field/sun.h"

namespace cydonia::render {

// Lambert shading: the share of the sun's light that falls on every sample, 0 to 1,
// without cast shadows. Slopes are central differences; heights and spacing are in
// metres.
Field<float> shading(const Field<float>& heights, double spacing, const Sun& sun);

}  // namespace cydonia::render
