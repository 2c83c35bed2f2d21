#pragma once

#include <cstdint>

#include "field/field.h"
#include "field/sun.h"

namespace cydonia::render {

// 1 in cells whose middle lies within two cells of the target's outline.
Field<std::uint8_t> near_outline(const Field<std::uint8_t>& target);

// Whether an image's outline shows in the ground's shading where its shadow is not: the
// mean gradient of Lambert shading (the light that falls on a sample, no cast shadow)
// where `near` is 1 over that elsewhere. 1 is invisible, also where nothing is near.
// `heights` in metres, at least 3 x 3; `near` as large, else bad_request.
double outline_shading(const Field<float>& heights, double spacing, const Sun& sun,
                       const Field<std::uint8_t>& near);

}  // namespace cydonia::render
