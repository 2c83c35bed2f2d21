#pragma once

#include <filesystem>

#include "app/library_analyst.h"
#include "synth/statistics/segmentation.h"

namespace cydonia {

// A land cut into a library's types.
struct TypeMap {
    // A type's index in the library, at each sample of the level; water and voids have
    // those of the land about them, kNoType amid large ones.
    Field<int> types;
    Studied land;
    std::vector<double> shares;  // of land, a type
};
// `library`: of windows.
TypeMap type_map(const statistics::Library& library, Studied land);

// The types' colours over shaded relief; water is dark blue, voids are black.
void write_type_picture(const std::filesystem::path& file,
                        const statistics::Library& library, const TypeMap& map);

// Each type's share and colour; of a land of several types the windows that are of one,
// as a library's TOML file has them. Whether it is mixed.
bool print_types(const statistics::Library& library, const TypeMap& map,
                 const std::filesystem::path& land);

}  // namespace cydonia
