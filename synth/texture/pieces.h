#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"
#include "synth/texture/places.h"

namespace cydonia::texture {

// Exemplar land that a synthesis starts from.
struct Piece {
    Spot middle;
    // What tells it from the others, in standard deviations of all: mean height, and the
    // logarithm of the mean slope.
    double height = 0.0, roughness = 0.0;
};

// The exemplars cut into pieces of `side` cells of the coarsest level, each place in one.
std::vector<Piece> pieces_of(const Database& database, int side);

// Blocks each way after which an arrangement comes again.
inline constexpr int kArrangement = 32;

// Which piece each block of the plane is. As far as possible from where the same piece
// lies, so that a feature comes into view twice only when there is no other; then unlike
// what lies around it, so that every part of the land is a fair sample of the exemplars.
Field<int> arranged(const std::vector<Piece>& pieces, std::uint64_t seed);

}  // namespace cydonia::texture
