#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "field/field.h"
#include "synth/texture/database/database.h"

namespace cydonia::texture {

// An exemplar from which a pyramid is made.
struct Land {
    std::string name;
    Field<float> heights;         // metres
    Field<std::uint8_t> voids;    // 1: interpolated; empty: nowhere
    Field<std::uint8_t> types{};  // T^0: kNoType, or an index below kMostTypes
};

// A Level under construction, which owns its arrays. A view() is valid as long as this
// lives.
struct LevelArrays {
    std::vector<Sheet> sheets;
    std::vector<float> heights;
    std::vector<Appearance> appearance;
    std::vector<Match> matches;
    std::vector<std::uint8_t> types;
    std::array<std::int8_t, 8> last_sign{};
    std::vector<std::vector<std::uint64_t>> seeds;

    Level view() const;
};

// The width in cells of the border of a sheet from which no land is taken, as a
// candidate's neighbourhood and its neighbours' must lie on the sheet. Coarse levels,
// whose cells are wide, have a narrower border: three cells of level 6 would be half of
// many exemplars (bench/realism.sh).
constexpr int border_of(int level) { return std::clamp(5 - level, 1, 3); }
// The shortest side of an exemplar that leaves a neighbourhood of 5x5 inside its borders.
inline constexpr int kShortestSide = 5 + 2 * border_of(0);

inline constexpr int kLongestSide = 16384;  // of an exemplar, cells
inline constexpr int kMostLevels = 15;

struct Size {
    int width = 0, height = 0;  // cells
};

// The size of the next coarser level. An odd last row or column is left out.
Size coarser_size(Size fine);

// Sheets of these sizes, one after another with their guards, in arrays of
// cells_of(sheets) cells.
std::vector<Sheet> sheets_of(std::span<const Size> sizes);
std::size_t cells_of(const std::vector<Sheet>& sheets);

// E^i and T^i, each half as wide as the one before (a pyramid, not a stack: section 4),
// with their guards. There are at most `most` levels: the first always, and others while
// some exemplar has land on them. Appearance and matches are left empty.
std::vector<LevelArrays> pyramid_of(std::vector<Land> lands, int most);

// Gives guard cells the values of the nearest border cell.
template <class T>
void fill_guard(const Sheet& sheet, std::vector<T>& values);

// The number of cells of a sheet from which land can be taken.
std::size_t places_of(const LevelArrays& level, const Sheet& sheet);

// Chooses up to kSeeds cells of each type as seeds, evenly over its land.
void sow(LevelArrays& level, int types);

template <class T>
void fill_guard(const Sheet& sheet, std::vector<T>& values) {
    const auto clamped = [](int at, int size) {
        return at < 0 ? 0 : at < size ? at : size - 1;
    };
    for (int y = -kGuard; y < sheet.height + kGuard; ++y) {
        for (int x = -kGuard; x < sheet.width + kGuard; ++x) {
            if (x == 0 && y >= 0 && y < sheet.height) x = sheet.width;
            values[sheet.index(x, y)] =
                values[sheet.index(clamped(x, sheet.width), clamped(y, sheet.height))];
        }
    }
}

}  // namespace cydonia::texture
