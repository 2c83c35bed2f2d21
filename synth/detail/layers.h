#pragma once

#include <array>
#include <optional>
#include <vector>

#include "field/field.h"
#include "synth/detail/example.h"

namespace cydonia::detail {

// A part of the land, and the target that its details come from.
struct Layer {
    Field<float> share;  // of each sample, 0 to 1; empty: 1 everywhere
    int target = -1;     // index in Options::targets; -1: any of them
    // The shift from the land's samples to the target's, a multiple of 2^levels, if it is
    // given rather than searched for.
    std::optional<std::array<int, 2>> shift;
};

// The layers that mappings or a painting give a land of width x height samples; without
// them one layer with all targets. Later mappings lie over earlier ones; edges are soft.
// Throws bad_request for a mapping that leaves its target.
std::vector<Layer> layers_of(const Options& options, std::span<const Example> examples,
                             int width, int height);

// The side of a block in samples, in a land of this size.
double block_side(const Options& options, int width, int height);

}  // namespace cydonia::detail
