#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "field/field.h"
#include "synth/genetic/evolution/samples.h"

namespace cydonia::genetic {

// A square chunk of land from a sample (section IV.3.3.4, figure IV.17).
struct Gene {
    std::int32_t sample = -1;   // in LevelSamples::all
    std::int32_t x = 0, y = 0;  // its north-west corner in the sample
    std::uint8_t turn = 0;      // below kTurns: quarter turns, with or without mirroring
    float scale = 1.0f;         // factor of heights
    bool operator==(const Gene&) const = default;
};
inline constexpr int kTurns = 8;
inline constexpr int kMostSide = 64;  // largest side of a gene, cells

// Where a gene's cells lie in an array with rows of `stride`: cell (x, y) is at start + x
// * east + y * south.
struct Layout {
    std::ptrdiff_t start = 0, east = 1, south = 0;
};
Layout layout_of(const Gene& gene, int side, int stride);

// The gene, `side` cells wide, that continues the land of `from`, which is `from_side`
// wide, at `dx` cells east and `dy` south of its north-west corner. The new gene's cells
// are `ratio` times finer. Its land may lie outside the sample.
Gene continued(const Gene& from, int from_side, int ratio, int dx, int dy, int side);

// The gene, moved onto the sample if it lies outside.
Gene kept_inside(Gene gene, int side, const Sample& sample);

// The slots of genes over a field (figure IV.18). There is a layer for each type, as a
// gene takes its land from one type. Genes are `side` cells wide, and each overlaps the
// next by `overlap` cells.
struct GeneGrid {
    int width = 0, height = 0;  // of the field
    int side = 16, overlap = 5;
    int columns = 0, rows = 0;
    struct Slot {
        std::uint8_t layer;  // in `types`
        std::int16_t column, row;
    };
    std::vector<int> types;               // of each layer, as an index in the library
    std::vector<Field<float>> weights;    // of each layer, 0 to 1; they sum to 1
    std::vector<Slot> slots;              // wherever a layer has any weight
    std::vector<Field<std::int32_t>> at;  // slots of each layer, columns x rows, or -1

    int step() const { return side - overlap; }
    int slot(int layer, int column, int row) const {
        return column < 0 || row < 0 || column >= columns || row >= rows
                   ? -1
                   : at[std::size_t(layer)](column, row);
    }
};

GeneGrid grid_of(const Field<std::uint8_t>& types, int side, int overlap);

}  // namespace cydonia::genetic
