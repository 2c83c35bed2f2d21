#include "app/library_types.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/library_colours.h"
#include "render/maps/hillshade.h"

namespace cydonia {
namespace {

constexpr double kMixed = 0.15;  // of land, of the second type
constexpr Rgb8 kWater = {24, 44, 84}, kVoid = {0, 0, 0}, kNone = {150, 150, 150};

// A window of the model, in shares, all of it within the rectangle.
std::string window_text(const statistics::Rectangle& r, int width, int height) {
    const auto up = [](double share) {
        return std::max(0.0, std::ceil(share * 1000.0 - 1e-6)) / 1000.0;
    };
    const auto down = [](double share) {
        return std::floor(share * 1000.0 + 1e-6) / 1000.0;
    };
    return fmt::format("[{:.3f}, {:.3f}, {:.3f}, {:.3f}]", up(double(r.x0) / width),
                       up(1.0 - double(r.y1) / height), down(double(r.x1) / width),
                       down(1.0 - double(r.y0) / height));
}

}  // namespace

TypeMap type_map(const statistics::Library& library, Studied land) {
    const Field<std::uint8_t> inside = land.inside();
    TypeMap map;
    map.types = statistics::sample_types(
        statistics::block_types(library,
                                statistics::window_analyses(land.terrain, inside)),
        land.terrain.heights.width(), land.terrain.heights.height());
    map.shares.assign(library.types().size(), 0.0);
    double all = 0.0;
    for (std::size_t i = 0; i < map.types.size(); ++i)
        if (map.types[i] != statistics::kNoType && (inside.empty() || inside[i]))
            map.shares[std::size_t(map.types[i])] += 1.0, all += 1.0;
    for (double& share : map.shares) share /= std::max(1.0, all);
    map.land = std::move(land);
    return map;
}

void write_type_picture(const std::filesystem::path& file,
                        const statistics::Library& library, const TypeMap& map) {
    const Terrain& terrain = map.land.terrain;
    const Field<float> shade = render::relief(terrain.heights, terrain.spacing);
    Field<Rgb8> picture(shade.width(), shade.height());
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const int type = map.types[i];
        Rgb8 colour = type == statistics::kNoType
                          ? kNone
                          : library.types()[std::size_t(type)].colour;
        double light = 0.25 + 0.95 * double(shade[i]), white = 0.2;
        if (!map.land.water.empty() && map.land.water[i])
            colour = kWater, light = 1.0, white = 0.0;
        if (!map.land.voids.empty() && map.land.voids[i])
            colour = kVoid, light = 1.0, white = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
            picture[i][c] = std::uint8_t(std::clamp(
                light * (white * 255.0 + (1.0 - white) * colour[c]), 0.0, 255.0));
    }
    write_png(file, picture);
}

bool print_types(const statistics::Library& library, const TypeMap& map,
                 const std::filesystem::path& land) {
    std::vector<std::size_t> order;  // by their shares
    for (std::size_t t = 0; t < map.shares.size(); ++t)
        if (map.shares[t] > 0.0) order.push_back(t);
    std::ranges::stable_sort(order, std::greater<>{},
                             [&](std::size_t t) { return map.shares[t]; });
    fmt::print("types at {:g} m, of its land\n", map.land.terrain.spacing);
    for (const std::size_t t : order)
        fmt::print("  {:>4.1f}%  {:10}  {}\n", 100.0 * map.shares[t],
                   hex_of(library.types()[t].colour), library.types()[t].name);
    if (order.size() < 2 || map.shares[order[1]] < kMixed) return false;
    fmt::print("windows of one type, as examples\n");
    for (const std::size_t t : order) {
        if (map.shares[t] < kMixed) break;
        const statistics::Rectangle r = statistics::largest_rectangle(map.types, int(t));
        if (std::min(r.x1 - r.x0, r.y1 - r.y0) < kFewestSamples)
            fmt::print("    # {}: none of {} samples a side\n", library.types()[t].name,
                       kFewestSamples);
        else
            // JSON's strings are TOML's.
            fmt::print("    # {}\n    {{ source = {}, window = {} }},\n",
                       library.types()[t].name, nlohmann::json(land.string()).dump(),
                       window_text(r, map.types.width(), map.types.height()));
    }
    return true;
}

}  // namespace cydonia
