#pragma once

#include <cstdint>

#include "field/field.h"
#include "field/sun.h"

namespace cydonia::render {

// 1 in cells whose middle lies within two cells of the target's outline.
Field<std::uint8_t> near_outline(const Field<std::uint8_t>& target);

// How much an image's outline shows in the shading of the ground, without cast shadows:
// the mean gradient of Lambert shading where `near` is 1, divided by that elsewhere. 1 is
// invisible and also the result when `near` is empty of ones. `heights` are in metres, at
// least 3 x 3. Throws bad_request when `near` has another shape.
double outline_shading(const Field<float>& heights, double spacing, const Sun& sun,
                       const Field<std::uint8_t>& near);

}  // namespace cydonia::render
