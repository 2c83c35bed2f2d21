#pragma once

#include <Eigen/Core>
#include <vector>

#include "synth/texture/synthesis/character.h"

namespace cydonia::texture {

// Square pieces of the exemplars' land, which overlap, and what it costs to lay them
// beside each other. Matrices, piece by piece.
struct Pieces {
    std::vector<Spot> middles;
    // How unlike they are where they meet, the one west or north of the other: squared
    // standard deviations. kFollowing more where that is much as in the exemplar.
    Eigen::MatrixXf west, north;
    Eigen::MatrixXf same;  // share of the one's land that is the other's too
};
inline constexpr float kFollowing = 100.0f;

// Pieces of `side` cells of a level, as many as there is time to compare. `character` is
// of that level. Nothing is taken from within `border` cells of an exemplar's edge. Each
// is turned or mirrored in one of the orientations that are allowed.
Pieces pieces_of(const Character& character, int side, int border, int orientations);

}  // namespace cydonia::texture
