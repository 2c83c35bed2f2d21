#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "synth/texture/options.h"

namespace cydonia::texture {

// A cell in appearance space (section 4; Lefebvre and Hoppe 2006): the weighted mean
// height of its 5x5 neighbourhood, above the middle of all exemplars' heights, then three
// modes of what is left without that mean, all in the database's units. The first two are
// odd in x and in y and each other's transpose; the last is even or odd in each. So the
// modes of a turned or mirrored neighbourhood are the same numbers with other places and
// signs.
using Appearance = std::array<std::int16_t, 4>;

// C_2, eq. 3: where an exemplar of the same level looks most alike, and how it must be
// laid down for that (synth/texture/database/orientation.h).
struct Match {
    std::uint16_t x = 0, y = 0;
    std::uint8_t exemplar = 0;
    std::uint8_t orientation = 0;
    bool operator==(const Match&) const = default;
};

// In Level::types: no land may be taken from here (near a border or a void).
inline constexpr std::uint8_t kNowhere = 255;
inline constexpr std::uint8_t kNoType = 254;  // land of no type
inline constexpr int kMostTypes = 32;
inline constexpr int kMostExemplars = 255;
inline constexpr int kGuard = 6;  // cells around each sheet that repeat its border

// One exemplar at one level.
struct Sheet {
    int width = 0, height = 0;  // cells, without guard
    int stride = 0;             // cells from a row to the next
    std::size_t origin = 0;     // of its cell (0, 0) in the level's arrays

    std::size_t index(int x, int y) const {
        return origin + static_cast<std::size_t>(std::ptrdiff_t(y) * stride + x);
    }
    std::size_t cells() const { return std::size_t(width) * std::size_t(height); }
};

// E^i, A^i, C^i and T^i of all exemplars; arrays are parallel and views of a file.
struct Level {
    std::span<const Sheet> sheets;   // one an exemplar
    std::span<const float> heights;  // metres
    std::span<const Appearance> appearance;
    std::span<const Match> matches;
    std::span<const std::uint8_t> types;  // index in Options::types, or as above
    // What the last mode of an orientation is multiplied by: 1 or -1.
    std::array<std::int8_t, 8> last_sign{};
    // For each type, where it is: exemplar << 48 | y << 24 | x, at most kSeeds of them.
    std::vector<std::span<const std::uint64_t>> seeds;
};
inline constexpr int kSeeds = 1024;

// Everything that is known of the exemplars before any land is made of them.
class Database {
  public:
    virtual ~Database() = default;

    double spacing = 1.0;                 // metres, of level 0
    double unit = 1.0;                    // metres, of heights in appearance space
    float lowest = 0.0f, highest = 0.0f;  // of all exemplars, metres
    std::vector<std::string> names;       // of the exemplars
    std::vector<Level> levels;  // E^0 first; as many as leave some exemplar land

    std::uint64_t cells() const;  // of the exemplars at level 0
};

// From the file in `cache` when it holds just that, else made and kept there. An empty
// folder, or one that cannot be written: not kept (a warning says so). Throws bad_request
// for exemplars that cannot be used.
std::shared_ptr<const Database> database_of(const Options& options,
                                            const std::filesystem::path& cache,
                                            Progress& progress);

}  // namespace cydonia::texture
