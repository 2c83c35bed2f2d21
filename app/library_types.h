#pragma once

#include <filesystem>

#include "app/library_analyst.h"
#include "synth/statistics/segmentation.h"

namespace cydonia {

// A land divided into the types of a library.
struct TypeMap {
    // The index of a type in the library for each sample of the level. Water and voids
    // take that of the land around them; far inside large ones it is kNoType.
    Field<int> types;
    Studied land;
    std::vector<double> shares;  // of each type in the land
};
// `library` holds analyses of windows.
TypeMap type_map(const statistics::Library& library, Studied land);

// Shaded relief in the types' colours; water is dark blue, voids are black.
void write_type_picture(const std::filesystem::path& file,
                        const statistics::Library& library, const TypeMap& map);

// Prints each type's share and colour. If the land is mixed, also prints the windows that
// hold a single type, as lines of a library's TOML file. Returns whether it is mixed.
bool print_types(const statistics::Library& library, const TypeMap& map,
                 const std::filesystem::path& land);

}  // namespace cydonia
