// Maps drawn in a geographic information system: polygons with a terrain type.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/reader/map_formats.h"
#include "field/areas.h"
#include "field/error.h"

namespace cydonia::config {
namespace {

constexpr double kFarthest = 1e9;  // in the map's unit, from its origin

bool is_line(const std::string& text) {
    return !text.empty() && text.size() <= 64 &&
           std::ranges::none_of(text, [](unsigned char c) { return c < ' '; });
}

std::string attribute(const Area& area, const char* name) {
    const auto found = area.attributes.find(name);
    return found == area.attributes.end() ? "" : found->second;
}

// Why a ring is no outline; empty when it is one.
std::string fault_of(const std::vector<std::array<double, 2>>& ring) {
    for (const auto& [x, y] : ring)
        if (!(std::abs(x) < kFarthest && std::abs(y) < kFarthest))
            return "a corner lies more than 1e9 away from the origin";
    if (ring.size() < 4)
        return "a ring has fewer than four corners, the first repeated at its end "
               "included";
    if (ring.front() != ring.back())
        return "a ring does not end where it begins; repeat its first corner at its end";
    return {};
}

}  // namespace

genetic::MapOptions map_from_ogr(const std::filesystem::path& file, VectorFormat format) {
    std::error_code none;
    if (std::filesystem::file_size(file, none) > kMostMapBytes && !none)
        throw bad_request("{}: it has more than {} bytes", file.string(), kMostMapBytes);
    genetic::MapOptions map;
    map.window = {};
    for (Area& area : read_areas(file, format, kMostMapCorners)) {
        const auto wrong = [&](const std::string& why) {
            return bad_request("{}: feature {}: {}", file.string(), area.number, why);
        };
        std::string type = attribute(area, "type");
        if (type.empty()) type = attribute(area, "terrain");
        if (area.rings.empty()) {
            if (type.empty()) continue;
            throw wrong(fmt::format(
                "it is of type '{}' but has no outline that can be read; draw its "
                "polygon or delete the feature",
                type));
        }
        if (!is_line(type))
            throw wrong(
                "it needs an attribute 'type' that names a terrain type of the library");
        if (map.regions.size() == kMostMapRegions)
            throw wrong(fmt::format("the map has more than {} regions", kMostMapRegions));
        std::string name = attribute(area, "name");
        if (!is_line(name)) name = name_of_region(map, type);
        for (auto& ring : area.rings) {
            if (const std::string fault = fault_of(ring); !fault.empty())
                throw wrong(fault);
            ring.pop_back();
        }
        map.regions.push_back({std::move(name), std::move(type), std::move(area.rings)});
    }
    return map;
}

}  // namespace cydonia::config
