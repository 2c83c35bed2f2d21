#pragma once

#include "field/terrain.h"
#include "synth/context.h"
#include "synth/detail/example.h"
#include "synth/detail/layers.h"

namespace cydonia::detail {

// The land with the details of real land in place of its own on the finest levels (Brosz
// 2007), all over or where mappings or the painting say so; elsewhere to the bit as it
// was. It is taken apart by the filter's reverse subdivision as often as there are levels
// and put together again level by level, at each with details of where the targets are
// most like the land by then. Throws bad_request: a target that is too coarse or too
// small, mappings that leave theirs.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 1;  // raised when the same options give other heights

// From a coarse land up, by as many levels as options say: sides as the filter divides
// them (20, 38, 74 and 146 samples with Chaikin's). `own`: the land's own details, the
// finest level first, for where layers leave some of them; may be empty. `side` of a
// block in samples of the finest level.
Field<float> refined(Field<float> coarse, std::span<const Level> own,
                     std::span<const Example> examples, std::span<const Layer> layers,
                     const Options& options, double side, std::uint64_t seed,
                     Progress& progress);

}  // namespace cydonia::detail
