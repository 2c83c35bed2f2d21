#pragma once

#include <Eigen/Core>
#include <vector>

#include "synth/texture/synthesis/character.h"

namespace cydonia::texture {

// Overlapping square pieces of the exemplars' land, and the cost of laying one beside
// another. Matrices have a row and a column for each piece.
struct Pieces {
    std::vector<Spot> middles;
    // The dissimilarity where two pieces meet, the first west or north of the second, in
    // squared standard deviations; kFollowing is added where they meet in much the same
    // way in the exemplar.
    Eigen::MatrixXf west, north;
    Eigen::MatrixXf same;  // share of a piece's land that is also the other's
};
inline constexpr float kFollowing = 100.0f;

// Pieces of `side` cells of the level of `character`, as many as can be compared in a
// reasonable time. None comes within `border` cells of an exemplar's edge. Each is turned
// or mirrored in one of the allowed orientations.
Pieces pieces_of(const Character& character, int side, int border, int orientations);

}  // namespace cydonia::texture
