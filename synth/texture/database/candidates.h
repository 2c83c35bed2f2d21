#pragma once

#include <span>

#include "synth/texture/database/best_match.h"

namespace cydonia::texture {

// Candidates for the best match of a cell.

// Every cell of the level.
void try_all(BestMatch& best, const LevelArrays& level, std::span<const int> turns);

// The two samples with the nearest traits in a leaf of the tree.
void try_similar(BestMatch& best, int orientation, const TraitSpace& space,
                 const KdTree& tree);

// The match of the coarser cell, refined: its four cells, turned with it.
void try_coarser(BestMatch& best, const LevelArrays& coarser);

// The cell beside the match of the neighbour in direction `towards`.
void try_beside(BestMatch& best, Step towards, const Match& neighbours);

// Random cells around the best one so far, different in each pass.
void try_around(BestMatch& best, int pass);

}  // namespace cydonia::texture
