#include "config/reader/map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "config/reader/map_formats.h"
#include "config/reader/mistakes.h"
#include "config/reader/parse.h"
#include "config/reader/readers.h"
#include "config/reader/thesis.h"
#include "field/error.h"
#include "field/files.h"

namespace cydonia::config {

using genetic::LibraryOptions;
using genetic::MapOptions;
using genetic::MapRegion;

namespace {

constexpr std::array<double, 4> kUnset{0.0, 0.0, 0.0, 0.0};

// The bounding box of all outlines.
std::array<double, 4> bounds_of(const MapOptions& map) {
    std::array<double, 4> box{1e300, 1e300, -1e300, -1e300};
    for (const MapRegion& region : map.regions)
        for (const auto& outline : region.outlines)
            for (const auto& [x, y] : outline)
                box = {std::min(box[0], x), std::min(box[1], y), std::max(box[2], x),
                       std::max(box[3], y)};
    return box;
}

std::string spaced(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

// Replaces the names of types by the library's spelling.
void name_types(MapOptions& map, const LibraryOptions& library) {
    for (MapRegion& region : map.regions)
        for (const auto& type : library.types)
            if (spaced(type.name) == spaced(region.type)) region.type = type.name;
}

std::optional<VectorFormat> vector_format(std::string_view extension) {
    if (extension == ".geojson" || extension == ".json") return VectorFormat::kGeoJson;
    if (extension == ".shp") return VectorFormat::kShapefile;
    if (extension == ".gpkg") return VectorFormat::kGeoPackage;
    return std::nullopt;
}

}  // namespace

void read(Table& t, MapOptions& map) {
    t.tables("region", map.regions, kMostMapRegions);
    map.window = kUnset;
    t.field("window", map.window, Number{from(-1e9, 1e9)});
    t.field("smoothness", map.smoothness, Number{from(0.0, 1.0)});
}

std::string name_of_region(const MapOptions& map, const std::string& type) {
    const auto alike = std::ranges::count(map.regions, type, &MapRegion::type);
    return alike == 0 ? type : fmt::format("{} {}", type, alike + 1);
}

MapOptions map_from_toml(const std::filesystem::path& file) {
    const Origins origins{file.string(), {}};
    const Value root = parse(read_text(file, kMostMapBytes), origins.file);
    Files files(file.parent_path());
    Reading reading{files};
    Table table(reading, &root, root.at);
    MapOptions map;
    read(table, map);
    table.report_unknown();
    if (!reading.mistakes.empty())
        throw bad_request("{}", listed(std::move(reading.mistakes), origins));
    return map;
}

MapOptions load_map(const std::filesystem::path& file, const LibraryOptions& library) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    MapOptions map;
    map.window = kUnset;
    if (extension == ".toml")
        map = map_from_toml(file);
    else if (const auto format = vector_format(extension))
        map = map_from_ogr(file, *format);
    else if (extension == ".svg")
        map = map_from_svg(file, library);
    else if (extension == ".map")
        map = map_from_thesis(file);
    else
        throw bad_request(
            "{}: a map is a .toml, .svg, .geojson, .shp, .gpkg or .map file",
            file.string());
    if (map.regions.empty())
        throw bad_request(
            "{}: it has no regions; give at least one outline with a terrain type",
            file.string());
    if (map.window == kUnset) map.window = bounds_of(map);
    if (!(map.window[0] < map.window[2] && map.window[1] < map.window[3]))
        throw bad_request(
            "{}: its window must be west, south, east and north, and enclose land",
            file.string());
    name_types(map, library);
    return map;
}

}  // namespace cydonia::config
