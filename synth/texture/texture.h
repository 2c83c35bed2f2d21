#pragma once

#include "field/terrain.h"
#include "synth/method.h"
#include "synth/texture/options.h"

namespace cydonia::texture {

// Replaces the land so far with land synthesised from real land (Gain, Merry and Marais
// 2015). Throws bad_request.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 4;  // raised when the same options give other heights

Method method_of(const Options& options);
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads);

// width x height of the heights that run() gives, from column x and row y on. They are
// equal to the last bit, as a cell depends on a bounded part of the plane. Not for land
// with breach or coherent.
int reach(const Options& options, const Extent& extent);
Field<float> tile(const Options& options, const Extent& extent, const Context& context,
                  int x, int y, int width, int height);

}  // namespace cydonia::texture
