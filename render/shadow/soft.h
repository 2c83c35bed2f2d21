#pragma once

#include "render/shadow/caster.h"

namespace cydonia::render {

// The sun is a disc, 0.53 degrees across. 1 where more than half of it is hidden: what
// an eye takes for the edge of a soft shadow. Shape as Caster::shadow; by 17 directions
// that lie evenly over the disc, cast only in the penumbrae.
Field<std::uint8_t> soft_shadow(const Caster& caster, const Sun& sun, int rays);

}  // namespace cydonia::render
