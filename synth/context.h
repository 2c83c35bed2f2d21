#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "field/image.h"
#include "field/progress.h"
#include "field/terrain.h"

namespace cydonia {

// The grid of samples of a terrain.
struct Extent {
    int columns = 0, rows = 0;
    double spacing = 1.0;  // metres

    double width() const { return spacing * columns; }
    double depth() const { return spacing * rows; }
};

// Receives pictures and tables that show how a stage made its land. Exists only when the
// user asked for an explanation.
struct Explain {
    // `name` says what the picture shows and is safe as a file name.
    std::function<void(const std::string& name, const Field<Rgb8>& picture)> picture;
    // `csv` is comma-separated values; its first line names the columns.
    std::function<void(const std::string& name, const std::string& csv)> table;
};

// Files in which a stage remembers something from run to run. Each method has a format of
// its own. A file may be damaged, or may belong to a land with other samples.
struct Memory {
    std::filesystem::path last;  // of the previous run; empty or missing: nothing
    std::filesystem::path next;  // where this run writes (field/files.h)
};

// What a stage may use besides its options and the terrain so far. app/ owns all of it.
struct Context {
    std::uint64_t seed =
        0;  // of this stage: a hash of the scene's seed and the stage's number
    // Casts hard shadows of a terrain under a sun with Embree. The result has `rays` x
    // `rays` samples a cell, so (rays * width) x (rays * height), and is 1 in shadow.
    std::function<Field<std::uint8_t>(const Terrain&, const Sun&, int rays)> cast;
    Progress* progress = nullptr;      // never null when a stage runs
    const Explain* explain = nullptr;  // null unless asked for
    const Memory* memory = nullptr;    // null where a stage remembers nothing
    // The folder of files that other runs can use, too; empty: there is none.
    std::filesystem::path cache = {};
};

}  // namespace cydonia
