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
// height of its 5x5 neighbourhood above the middle of all exemplars' heights, then three
// modes of the neighbourhood without that mean, all in the database's units. The first
// two are odd in x and in y and are each other's transpose; the last is even or odd in
// each. So the modes of a turned or mirrored neighbourhood are the same numbers, permuted
// and with other signs.
using Appearance = std::array<std::int16_t, 4>;

// C_2, eq. 3: the most similar cell of the exemplars at the same level, and the
// orientation in which it is most similar (synth/texture/database/orientation.h).
struct Match {
    std::uint16_t x = 0, y = 0;
    std::uint8_t exemplar = 0;
    std::uint8_t orientation = 0;
    bool operator==(const Match&) const = default;
};

// Values in Level::types. From cells of kNowhere, which are near a border or a void, no
// land may be taken.
inline constexpr std::uint8_t kNowhere = 255;
inline constexpr std::uint8_t kNoType = 254;  // land of no type
inline constexpr int kMostTypes = 32;
inline constexpr int kMostExemplars = 255;
inline constexpr int kGuard = 6;  // cells around each sheet that repeat its border

// One exemplar at one level.
struct Sheet {
    int width = 0, height = 0;  // cells, without guard
    int stride = 0;             // cells from a row to the next
    std::size_t origin = 0;     // index of its cell (0, 0) in the level's arrays

    std::size_t index(int x, int y) const {
        return origin + static_cast<std::size_t>(std::ptrdiff_t(y) * stride + x);
    }
    std::size_t cells() const { return std::size_t(width) * std::size_t(height); }
};

// E^i, A^i, C^i and T^i of all exemplars. The arrays are parallel; they are views of the
// database's memory.
struct Level {
    std::span<const Sheet> sheets;   // one for each exemplar
    std::span<const float> heights;  // metres
    std::span<const Appearance> appearance;
    std::span<const Match> matches;
    std::span<const std::uint8_t> types;  // index in Options::types, kNoType or kNowhere
    // The factor, 1 or -1, of the last mode in each orientation.
    std::array<std::int8_t, 8> last_sign{};
    // Some cells of each type, at most kSeeds: exemplar << 48 | y << 24 | x.
    std::vector<std::span<const std::uint64_t>> seeds;
};
inline constexpr int kSeeds = 1024;

// Everything that is computed from the exemplars before land is made from them.
class Database {
  public:
    virtual ~Database() = default;

    double spacing = 1.0;                 // metres, of level 0
    double unit = 1.0;                    // metres, of heights in appearance space
    float lowest = 0.0f, highest = 0.0f;  // of all exemplars, metres
    std::vector<std::string> names;       // of the exemplars
    std::vector<Level> levels;            // E^0 first; while some exemplar has land left

    std::uint64_t cells() const;  // of the exemplars at level 0
};

// The exemplars' database, read from its file in the folder `cache`, or else computed and
// written there. With an empty `cache` it is not written; when writing fails, a warning
// says so. Throws bad_request for exemplars that cannot be used.
std::shared_ptr<const Database> database_of(const Options& options,
                                            const std::filesystem::path& cache,
                                            Progress& progress);

}  // namespace cydonia::texture
