#pragma once

#include <ogr_spatialref.h>

#include <array>
#include <string>
#include <vector>

#include "field/source.h"
#include "field/terrain.h"

namespace cydonia {

// Internal to field/: steps of read_dem, each throwing bad_request without the file's
// name.

// An elevation model on the grid of its file, row 0 in the north.
struct DemGrid {
    Field<float> heights;  // metres; NaN where there is none
    // Metres, degrees or feet of `plane`: x = t[0] + column t[1], y = t[3] + row t[5] at
    // the cells' corners, t[1] > 0 and t[5] < 0. It is never turned: t[2] = t[4] = 0.
    std::array<double, 6> transform{};
    OGRSpatialReference plane;  // empty when the file names none
};

// Sentences about what was done to a file, for its reader's `note`.
using Notes = std::vector<std::string>;

// Reads the first band of a file through GDAL and turns it north up.
DemGrid dem_grid(const Source& source, Notes& notes);

// Reads only the header of such a file and returns its number of heights.
std::uint64_t samples_of_grid(const Source& source);

// A mask that is 1 where a height is not finite; empty when all heights are finite.
Field<std::uint8_t> voids_of(const Field<float>& heights);

// Interpolates the cells that are not finite. Throws when they are more than the share
// `most` of all cells.
constexpr double kMostVoids = 0.2;
void fill_voids(Field<float>& heights, double most, Notes& notes);

// The same heights in square cells, in metres on the ground. The file's own cells are
// kept where they are square within 1%; otherwise about as many new ones are interpolated
// (cubic), in a plane that touches the ground at the grid's middle. The heights must have
// no voids.
Terrain on_square_metres(const DemGrid& grid, Notes& notes);

}  // namespace cydonia
