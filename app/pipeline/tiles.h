#pragma once

#include "app/pipeline/steps.h"

namespace cydonia {

// Land too large for memory ([terrain] tiles): every tile in a file of its own below
// tiles/, made in any order and by any process, then all of them put together.

// Throws bad_request for what a land in tiles cannot be asked for, and for a tile that
// the land does not have.
void check_request(const Job& job, Goal goal);

// Makes the tiles that are not there yet and puts all together: terrain.tif, terrain.exr
// and a picture. In place of all other steps.
Step tiles_step(const Job& job);

// The one tile of the request; other processes may be at work on others.
void make_tile(const Job& job);

// "16 x 16 tiles, 3 of 256 made".
std::string tiles_text(const Job& job);

}  // namespace cydonia
