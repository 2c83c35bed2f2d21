#pragma once

#include <vector>

#include "render/shadow/caster.h"

namespace cydonia::render {

// Soft shadows of the sun as a disc, 0.53 degrees across, sampled by directions.
inline constexpr int kDiscDirections = 17;
// 2 * pairs directions spread evenly over the disc, and 4 on a circle of the given
// multiple of its radius.
std::vector<Sun> sun_disc(const Sun& sun, int pairs);
std::vector<Sun> sun_rim(const Sun& sun, double radii);

// The number of directions in which the sun is occluded, for samples as in
// Caster::shadow. They are cast only in penumbrae: where all directions of the rim, at
// one sample a cell, are lit or all are dark, the samples are too.
Field<std::uint8_t> hidden_sun(const Caster& caster, const Sun& sun, int rays);

// 1 where more than half of the disc is occluded, which the eye takes for shadow.
Field<std::uint8_t> soft_shadow(const Caster& caster, const Sun& sun, int rays);

}  // namespace cydonia::render
