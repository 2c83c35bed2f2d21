#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"

namespace cydonia::pareidolia {

// A point of the grid in cells: (x, y) is the centre of cell (x, y), y grows south.
struct GridPoint {
    double x = 0.0, y = 0.0;
};

// The cell that a point lies in, whether on the grid or not.
struct Cell {
    int x = 0, y = 0;
};
Cell cell_of(GridPoint p);

// A square grid over the whole terrain turned so that light runs along its rows, from the
// left (Rusnell 2009, Algorithm 4, step 3).
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

// For a sun at `azimuth` (radians) over width x height cells.
LightFrame light_frame(int width, int height, double azimuth, int density);

// I_r: the image as the frame's samples see it, 0 beyond its edges.
Field<std::uint8_t> rotated(const Field<std::uint8_t>& image, const LightFrame& frame);

// A shadow along a row of the frame: samples [first, past).
struct Run {
    int row = 0, first = 0, past = 0;
};

// Step 5: every shadow of a rotated image, row by row in the order of light.
std::vector<Run> runs_of(const Field<std::uint8_t>& rotated);

// Step 2: the azimuth, of 36 in half a turn, whose longest shadow is shortest
// (section 5.3), so that casters stay low. Radians; of equal ones the first from north
// clockwise.
double shortest_azimuth(const Field<std::uint8_t>& image);

}  // namespace cydonia::pareidolia
