#pragma once

#include "field/terrain.h"
#include "synth/detail/example.h"
#include "synth/detail/layers.h"
#include "synth/detail/options.h"
#include "synth/detail/window.h"
#include "synth/method.h"

namespace cydonia::detail {

// Replaces the details of the land on its finest levels with those of real land (Brosz
// 2007): everywhere, or where mappings or a painting say so; elsewhere the land is
// unchanged to the bit. The land is decomposed by the filter's reverse subdivision as
// often as there are levels and then rebuilt level by level, each time with details from
// where the targets are most similar to the land so far. Throws bad_request for a target
// that is too coarse or too small and for a mapping that leaves its target.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 1;  // raised when the same options give other heights

Method method_of(const Options& options);
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads);

// width x height of the heights that run() gives, from column x and row y on, equal to
// the last bit. Not with PatchMatch, which passes matches on from block to block, nor
// with a painting or mappings.
Field<float> tile(const Options& options, const Extent& extent, const Heights& before,
                  const Context& context, int x, int y, int width, int height);

// How many samples beyond a tile its heights may depend on, in a land of this extent.
int reach(const Options& options, const Extent& extent);

// Refines a coarse land by as many levels as the options say. Sides grow as the filter
// subdivides them (20, 38, 74 and 146 samples with Chaikin's). `own` are the land's own
// details, the finest level first, for places that layers do not cover; may be empty.
// `window` tells of which whole land the result is a part, at a multiple of 2^levels
// samples; an empty one: of none. `side` is that of a block in samples of the result.
Field<float> refined(Field<float> coarse, std::span<const Level> own,
                     std::span<const Example> examples, std::span<const Layer> layers,
                     const Options& options, const Window& window, double side,
                     std::uint64_t seed, Progress& progress);

}  // namespace cydonia::detail
