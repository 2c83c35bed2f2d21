#pragma once

#include "app/pipeline/steps.h"

namespace cydonia {

// Land too large for memory ([terrain] tiles). Each tile is a file in tiles/; any process
// may make them, in any order. At the end they are put together.

// Throws bad_request for goals and options that a land in tiles cannot have, and for a
// tile that the land does not have.
void check_request(const Job& job, Goal goal);

// The only step of a land in tiles. Makes the tiles that are missing and puts them
// together: terrain.tif, terrain.exr and preview.png.
Step tiles_step(const Job& job);

// Makes the tile of the request, while other processes may make others.
void make_tile(const Job& job);

// "16 x 16 tiles, 3 of 256 made".
std::string tiles_text(const Job& job);

}  // namespace cydonia
