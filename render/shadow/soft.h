#pragma once

#include <vector>

#include "render/shadow/caster.h"

namespace cydonia::render {

// The sun is a disc, 0.53 degrees across: directions that lie evenly over it.
inline constexpr int kDiscDirections = 17;
// 2 * pairs such places, and 4 on a circle of so many times the disc's radius.
std::vector<Sun> sun_disc(const Sun& sun, int pairs);
std::vector<Sun> sun_rim(const Sun& sun, double radii);

// From how many of them the sun is hidden, for samples as in Caster::shadow. They are
// cast only in the penumbrae: where the disc's rim, at a sample a cell, sees all lit or
// all dark, so is the sample.
Field<std::uint8_t> hidden_sun(const Caster& caster, const Sun& sun, int rays);

// 1 where more than half of it is: what an eye takes for the edge of a soft shadow.
Field<std::uint8_t> soft_shadow(const Caster& caster, const Sun& sun, int rays);

}  // namespace cydonia::render
