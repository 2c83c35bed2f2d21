#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"

namespace cydonia::pareidolia {

// A point of the grid in cells. Integers are the centres of cells, and y grows south.
struct GridPoint {
    double x = 0.0, y = 0.0;
};

// The cell that contains a point, which may lie outside the grid.
struct Cell {
    int x = 0, y = 0;
};
Cell cell_of(GridPoint p);

// A square grid over the whole terrain, turned so that light travels along its rows from
// the left (Rusnell 2009, Algorithm 4, step 3).
struct LightFrame {
    GridPoint centre;  // of the terrain
    GridPoint along;   // the way light travels over the ground, a unit vector
    GridPoint across;  // from a row to the next
    int density = 1;   // rows a cell, and samples a cell along them
    int side = 0;      // rows, and samples in a row

    GridPoint position(double sample, double row) const;  // in cells
    double sample_at(GridPoint p) const;
    double row_at(GridPoint p) const;
};

// The frame for a sun at `azimuth` (radians) over width x height cells.
LightFrame light_frame(int width, int height, double azimuth, int density);

// I_r: the image at the frame's samples, 0 beyond its edges.
Field<std::uint8_t> rotated(const Field<std::uint8_t>& image, const LightFrame& frame);

// A shadow along a row of the frame: samples [first, past).
struct Run {
    int row = 0, first = 0, past = 0;
};

// Step 5: every shadow of a rotated image, row by row in the order of light.
std::vector<Run> runs_of(const Field<std::uint8_t>& rotated);

// Step 2: of 36 azimuths in half a turn, the one whose longest shadow is shortest
// (section 5.3), so that casters stay low. In radians; of equal ones it is the first one
// clockwise from north.
double shortest_azimuth(const Field<std::uint8_t>& image);

}  // namespace cydonia::pareidolia
