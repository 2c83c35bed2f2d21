#pragma once

#include "field/progress.h"
#include "synth/texture/database/pyramid.h"

namespace cydonia::texture {

// The dissimilarity of a cell and its match: the mean squared difference that is left
// when the match is laid down with its orientation and raised or lowered to fit best. In
// squared units of appearance space.
float dissimilarity(const LevelArrays& level, int exemplar, int x, int y,
                    const Match& match);

// Fills in C^i_2 (eq. 3), including guards. A match in the same exemplar is more than 5
// cells away. The result is the same for any number of threads. `coarser` is the next
// level, whose matches are known, or null; `orientations` is 1, 2, 4 or 8. Progress is
// reported from `begin` to `end`.
void add_matches(LevelArrays& level, const LevelArrays* coarser, int orientations,
                 Progress& progress, double begin, double end);

// The exact minimum over all cells, for tests.
float best_unlikeness(const LevelArrays& level, int exemplar, int x, int y,
                      int orientations);

}  // namespace cydonia::texture
