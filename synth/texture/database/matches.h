#pragma once

#include "field/progress.h"
#include "synth/texture/database/pyramid.h"

namespace cydonia::texture {

// How unlike a place and its match are: the mean square of what is left between them when
// the match is laid down with its orientation and raised or lowered to fit best. Units of
// appearance space, squared.
float unlikeness(const LevelArrays& level, int exemplar, int x, int y,
                 const Match& match);

// C^i_2 (eq. 3), guards too: of a place in the same exemplar never within 5 cells. The
// same for any number of threads. `coarser`: the next level, whose matches are known;
// null where there is none. `orientations`: 1, 2, 4 or 8. Progress is reported from
// `begin` to `end`.
void add_matches(LevelArrays& level, const LevelArrays* coarser, int orientations,
                 Progress& progress, double begin, double end);

// The least of all there are, for tests.
float best_unlikeness(const LevelArrays& level, int exemplar, int x, int y,
                      int orientations);

}  // namespace cydonia::texture
