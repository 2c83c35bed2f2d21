#pragma once

#include "field/field.h"

namespace cydonia {

// Where samples are taken from a grid, in cells of it: its north-west corner is (0, 0),
// y grows south.
struct SampleGrid {
    double west = 0.0, north = 0.0;  // of the samples' own corner
    double cell = 1.0;               // side of a sample
    // A part of a larger whole, equal to the whole's to the last bit: which of the
    // samples is the first, and which cell of the grid is `from`'s first.
    int column = 0, row = 0;
    int from_column = 0, from_row = 0;
};

// width x height samples of a grid: cubic between its cells (Keys 1981, a = -1/2) and,
// where a sample spans several, the same curve stretched over them. Samples that lie on
// the grid's own are those to the last bit. Beyond the grid its outermost heights.
Field<float> sampled(const Field<float>& from, const SampleGrid& grid, int width,
                     int height);

}  // namespace cydonia
