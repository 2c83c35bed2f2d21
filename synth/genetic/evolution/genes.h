#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "field/field.h"
#include "synth/genetic/evolution/samples.h"

namespace cydonia::genetic {

// A square chunk of land, taken from a sample (section IV.3.3.4, figure IV.17).
struct Gene {
    std::int32_t sample = -1;   // in LevelSamples::all
    std::int32_t x = 0, y = 0;  // of its north-west corner in the sample
    std::uint8_t turn = 0;      // below kTurns: quarter turns and mirrored ones
    float scale = 1.0f;         // of heights
    bool operator==(const Gene&) const = default;
};
inline constexpr int kTurns = 8;
inline constexpr int kMostSide = 64;  // cells of a gene

// How a gene's cells lie in an array with rows of `stride`: cell (x, y) of it is at
// start + x * east + y * south.
struct Layout {
    std::ptrdiff_t start = 0, east = 1, south = 0;
};
Layout layout_of(const Gene& gene, int side, int stride);

// The gene so wide that goes on with the same land `dx` cells east and `dy` south of the
// north-west corner of another, `from_side` wide; cells are `ratio` times finer than its.
// Its land may lie beyond the sample.
Gene continued(const Gene& from, int from_side, int ratio, int dx, int dy, int side);

// Moved onto the sample where it lies beyond.
Gene kept_inside(Gene gene, int side, const Sample& sample);

// Genes over a field (figure IV.18): one grid a type, since a gene takes its land from
// one type; `side` cells wide, each overlapping the next by `overlap`.
struct GeneGrid {
    int width = 0, height = 0;  // of the field
    int side = 16, overlap = 5;
    int columns = 0, rows = 0;
    struct Slot {
        std::uint8_t layer;  // in `types`
        std::int16_t column, row;
    };
    std::vector<int> types;               // in the library, one a layer
    std::vector<Field<float>> weights;    // of each layer, 0 to 1: their sum is 1
    std::vector<Slot> slots;              // where a layer has any weight
    std::vector<Field<std::int32_t>> at;  // of each layer, columns x rows: slot, or -1

    int step() const { return side - overlap; }
    int slot(int layer, int column, int row) const {
        return column < 0 || row < 0 || column >= columns || row >= rows
                   ? -1
                   : at[std::size_t(layer)](column, row);
    }
};

GeneGrid grid_of(const Field<std::uint8_t>& types, int side, int overlap);

}  // namespace cydonia::genetic
