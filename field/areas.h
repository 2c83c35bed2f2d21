#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cydonia {

// A feature of a vector file of a geographic information system.
struct Area {
    std::size_t number = 0;  // in its file, counted from one
    // By their names in lower case. Empty ones are left out.
    std::map<std::string, std::string> attributes;
    // In the file's coordinates, east then north; a ring ends where it begins, if the
    // file has it so. None when the feature has no geometry that can be read.
    std::vector<std::vector<std::array<double, 2>>> rings;
};

enum class VectorFormat { kGeoJson, kShapefile, kGeoPackage };

// The polygons of all layers in their order, curves as lines, and the features that have
// no geometry. Points and lines are left out. Throws bad_request with GDAL's reason when
// the file cannot be read in whole or has more than `most_corners` corners.
std::vector<Area> read_areas(const std::filesystem::path& file, VectorFormat format,
                             std::size_t most_corners);

}  // namespace cydonia
