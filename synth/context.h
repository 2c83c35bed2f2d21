#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "field/image.h"
#include "field/progress.h"
#include "field/terrain.h"

namespace cydonia {

// The samples of a terrain.
struct Extent {
    int columns = 0, rows = 0;
    double spacing = 1.0;  // metres

    double width() const { return spacing * columns; }
    double depth() const { return spacing * rows; }
};

// Where a stage shows how it came to its land, when that was asked for.
struct Explain {
    // `name` is a file-name-safe word: a picture of what it says.
    std::function<void(const std::string& name, const Field<Rgb8>& picture)> picture;
    // Comma-separated values, a line of names first.
    std::function<void(const std::string& name, const std::string& csv)> table;
};

// What a stage remembers from run to run: files in a format of its own, of any size. They
// may be damaged, or of a land of other samples.
struct Memory {
    std::filesystem::path last;  // what the run before kept; empty or missing: nothing
    std::filesystem::path next;  // what this run keeps goes here (field/files.h)
};

// What a stage may use besides its options and the terrain so far; owned by app/.
struct Context {
    std::uint64_t seed =
        0;  // of this stage: a hash of the scene's seed and the stage's place
    // Hard shadows of the terrain under the sun, as the Embree caster sees them: `rays` x
    // `rays` samples a cell, so (rays * width) x (rays * height), 1 in shadow.
    std::function<Field<std::uint8_t>(const Terrain&, const Sun&, int rays)> cast;
    Progress* progress = nullptr;      // never null when a stage runs
    const Explain* explain = nullptr;  // null unless asked for
    const Memory* memory = nullptr;    // null where nothing is kept
    // Where files that other runs can use are kept; empty: nowhere.
    std::filesystem::path cache = {};
};

}  // namespace cydonia
