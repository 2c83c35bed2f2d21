#pragma once

#include <filesystem>

#include "synth/genetic/options.h"

namespace cydonia::config {

// A map of terrain types, by its extension:
//   .toml      [[region]] with type, name and outline; window, smoothness
//   .svg       filled shapes in the types' colours, or called as a type
//   .geojson (.json), .shp, .gpkg
//              polygons with an attribute "type" (or "terrain"), read by GDAL's OGR
//   .map       the thesis' own (Saunders 2006, figure V.10): v, tt and f records
// Without a window it is what all regions cover, or the page of a drawing. The names of
// types may have underscores instead of spaces. Throws bad_request that names the file,
// and the line where the format has lines.
genetic::MapOptions load_map(const std::filesystem::path& file,
                             const genetic::LibraryOptions& library);

}  // namespace cydonia::config
