#pragma once

#include <span>

#include "synth/texture/database/best_match.h"

namespace cydonia::texture {

// What a cell's best match is looked for among.

// All there is.
void try_all(BestMatch& best, const LevelArrays& level, std::span<const int> turns);

// The two of a leaf that are nearest by their traits.
void try_alike(BestMatch& best, int orientation, const TraitSpace& space,
               const AlikeTree& tree);

// The four cells of a coarse one go on to the four of its match, turned with it.
void try_coarser(BestMatch& best, const LevelArrays& coarser);

// Where the match of the neighbour `towards` there has its neighbour on this side.
void try_beside(BestMatch& best, Step towards, const Match& neighbours);

// Places drawn around the best so far, others in each pass.
void try_around(BestMatch& best, int pass);

}  // namespace cydonia::texture
