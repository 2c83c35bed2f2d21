// The shapes of a drawing. Each is of the type whose name or colour it has.

#include <fmt/format.h>

#include <algorithm>

#include "config/reader/map_formats.h"
#include "config/reader/units.h"
#include "field/error.h"
#include "field/source.h"
#include "field/svg_paths.h"

namespace cydonia::config {
namespace {

constexpr double kTolerance = 0.0005;  // of the page
constexpr int kNear = 48;              // a channel, as paintings allow

int dissimilarity(const Colour::Rgb& a, const Colour::Rgb& b) {
    int most = 0;
    for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

std::string spaced(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

// The type of a path; empty when it has none.
std::string type_of(const SvgPath& path, const genetic::LibraryOptions& library) {
    for (const std::string& name : path.names)
        for (const auto& type : library.types)
            if (spaced(type.name) == spaced(name)) return type.name;
    if (!path.fill) return {};
    const auto nearest = std::ranges::min_element(
        library.types, {},
        [&](const auto& type) { return dissimilarity(type.colour, *path.fill); });
    if (nearest == library.types.end() ||
        dissimilarity(nearest->colour, *path.fill) > kNear)
        return {};
    return nearest->name;
}

}  // namespace

genetic::MapOptions map_from_svg(const std::filesystem::path& file,
                                 const genetic::LibraryOptions& library) {
    genetic::MapOptions map;
    map.window = {0.0, 0.0, 1.0, 1.0};
    std::size_t corners = 0, shape = 0;  // of the last region
    for (const SvgPath& path : svg_paths(open_source(file), kTolerance)) {
        // A filled shape is closed, whether it is drawn closed or not.
        const bool closed = path.points.front() == path.points.back();
        const std::size_t count = path.points.size() - (closed ? 1 : 0);
        if (count < 3 || (!closed && !path.fill)) continue;  // a line, a label's stroke
        const std::string type = type_of(path, library);
        if (type.empty()) {
            if (!path.fill) continue;
            const auto& c = *path.fill;
            throw bad_request(
                "{}: {}the colour #{:02x}{:02x}{:02x} is no type's; give a type that "
                "colour in the library, or name the shape after its type",
                file.string(), path.id.empty() ? "" : path.id + ": ", c[0], c[1], c[2]);
        }
        corners += count;
        if (corners > kMostMapCorners)
            throw bad_request("{}: more than {} corners", file.string(), kMostMapCorners);
        genetic::Outline outline;
        for (std::size_t i = 0; i < count; ++i)
            outline.push_back({path.points[i][0], 1.0 - path.points[i][1]});
        // Further outlines of one shape are its holes or islands.
        if (!map.regions.empty() && path.shape == shape) {
            map.regions.back().outlines.push_back(std::move(outline));
        } else {
            if (map.regions.size() == kMostMapRegions)
                throw bad_request("{}: more than {} regions", file.string(),
                                  kMostMapRegions);
            map.regions.push_back(
                {name_of_region(map, type), type, {std::move(outline)}});
        }
        shape = path.shape;
    }
    return map;
}

}  // namespace cydonia::config
