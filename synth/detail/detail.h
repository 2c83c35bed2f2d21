#pragma once

#include "field/terrain.h"
#include "synth/detail/example.h"
#include "synth/detail/layers.h"
#include "synth/detail/options.h"
#include "synth/detail/window.h"
#include "synth/method.h"

namespace cydonia::detail {

// The land with the details of real land in place of its own on the finest levels (Brosz
// 2007), all over or where mappings or the painting say so; elsewhere to the bit as it
// was. It is taken apart by the filter's reverse subdivision as often as there are levels
// and put together again level by level, at each with details of where the targets are
// most like the land by then. Throws bad_request: a target that is too coarse or too
// small, mappings that leave theirs.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 1;  // raised when the same options give other heights

Method method_of(const Options& options);
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads);

// width x height of the heights that run() gives, from column x and row y on, to the last
// bit. Not with PatchMatch, which goes on from block to block, nor with a painting or
// mappings.
Field<float> tile(const Options& options, const Extent& extent, const Heights& before,
                  const Context& context, int x, int y, int width, int height);

// How many samples beyond a tile of a land so large its heights may depend on.
int reach(const Options& options, const Extent& extent);

// From a coarse land up, by as many levels as options say: sides as the filter divides
// them (20, 38, 74 and 146 samples with Chaikin's). `own`: the land's own details, the
// finest level first, for where layers leave some of them; may be empty. `window`: of
// which whole the result is a part, at a multiple of 2^levels samples; empty: of none.
// `side`: of a block, in samples of the result.
Field<float> refined(Field<float> coarse, std::span<const Level> own,
                     std::span<const Example> examples, std::span<const Layer> layers,
                     const Options& options, const Window& window, double side,
                     std::uint64_t seed, Progress& progress);

}  // namespace cydonia::detail
