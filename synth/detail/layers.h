#pragma once

#include <array>
#include <optional>
#include <vector>

#include "field/field.h"
#include "synth/detail/example.h"

namespace cydonia::detail {

// A part of the land and the target that its details are from.
struct Layer {
    Field<float> share;  // 0 to 1, of the land's samples; empty: 1 everywhere
    int target = -1;     // its place in Options::targets; -1: whichever suits
    // From the land's samples to the target's, where that is not searched for: a multiple
    // of 2^levels.
    std::optional<std::array<int, 2>> shift;
};

// What mappings, or the painting, say of a land of so many samples; else one layer of all
// targets. Mappings that come later lie over those before; edges are soft. Throws
// bad_request: a mapping that leaves its target.
std::vector<Layer> layers_of(const Options& options, std::span<const Example> examples,
                             int width, int height);

// The side of a block, of a land so large.
double block_side(const Options& options, int width, int height);

}  // namespace cydonia::detail
