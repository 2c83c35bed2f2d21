#pragma once

#include "field/field.h"

namespace cydonia {

// Where samples are taken from a grid, in cells of that grid. Its north-west corner is
// (0, 0), and y grows south.
struct SampleGrid {
    double west = 0.0, north = 0.0;  // of the samples' own corner
    double cell = 1.0;               // side of a sample
    // For a part of a larger whole that equals the whole to the last bit: the index of
    // the part's first sample, and the cell of the grid that is `from`'s first.
    int column = 0, row = 0;
    int from_column = 0, from_row = 0;
};

// Takes width x height samples of a grid. They are cubic between the grid's cells (Keys
// 1981, a = -1/2); where a sample spans several cells, the same curve is stretched over
// them. A sample at the centre of a cell equals it to the last bit. Beyond the grid its
// outermost heights continue.
Field<float> sampled(const Field<float>& from, const SampleGrid& grid, int width,
                     int height);

}  // namespace cydonia
