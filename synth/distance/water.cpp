// B. Rusnell, "Distance-based terrain synthesis" (2009), section 6.2.

#include "synth/distance/water.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/strokes.h"
#include "synth/distance/growth.h"

namespace cydonia::distance {
namespace {

Field<std::uint8_t> drawn(const Source& image, const Graph& graph) {
    const Field<float> grey = read_grey_at(image, graph.width, graph.height);
    Field<std::uint8_t> wet(graph.width, graph.height);
    std::ranges::transform(grey, wet.begin(), [](float g) { return g < 0.5f ? 1 : 0; });
    const auto count = static_cast<std::size_t>(std::ranges::count(wet, 1));
    if (count == 0 || count == wet.size()) {
        throw bad_request(
            "water: {} shows {}: draw the water dark and leave the land light",
            image.name(), count == 0 ? "no water" : "nothing but water");
    }
    return wet;
}

// The wet samples that touch dry land.
std::vector<Start> shore_of(const Field<std::uint8_t>& wet, const Graph& graph) {
    std::vector<Start> shore;
    for (int y = 0; y < wet.height(); ++y) {
        for (int x = 0; x < wet.width(); ++x) {
            if (!wet(x, y)) continue;
            const auto dry = [&](int dx, int dy) {
                return wet.contains(x + dx, y + dy) && !wet(x + dx, y + dy);
            };
            if (dry(-1, 0) || dry(1, 0) || dry(0, -1) || dry(0, 1)) {
                shore.push_back({graph.node(x, y), 0.0f});
            }
        }
    }
    return shore;
}

float lowest_land(const std::vector<Start>& shore, const Field<float>& land,
                  const Graph& graph) {
    float lowest = kUnreached;
    for (const Start& start : shore) {
        lowest = std::min(lowest, land(graph.x_of(start.node), graph.y_of(start.node)));
    }
    return lowest;
}

// How deep the bed lies below the surface, by node of `paths`.
void spread_bed(LeastCost& paths, const std::vector<Start>& shore, const Water& water,
                const Options& options, double width) {
    const double depth = water.depth.in(width);
    const auto bed = std::ranges::find(options.profiles, water.bed, &Profile::name);
    Shapes shapes{depth, options.mean_edge_weight, {}, {}, {}, {}, {}, {}};
    shapes.descents.push_back(
        descent_of(*bed, depth, options.mean_edge_weight, options.minimum_scale, width));
    shapes.ways.assign(shore.size(), 0);
    const auto deepest = static_cast<float>(depth);
    paths.spread(shore, ProfileGrowth(shapes, shore, 0),
                 [&](int, float cost) { return cost < deepest; });
}

void lay(Terrain& terrain, const Water& water, const Options& options, const Graph& graph,
         LeastCost& paths) {
    const Field<std::uint8_t> wet = drawn(water.image, graph);
    const std::vector<Start> shore = shore_of(wet, graph);
    const double width = terrain.width();
    const float level = water.level ? static_cast<float>(water.level->in(width))
                                    : lowest_land(shore, terrain.heights, graph);
    const auto depth = static_cast<float>(water.depth.in(width));

    spread_bed(paths, shore, water, options, width);
    for (int y = 0; y < graph.height; ++y) {
        for (int x = 0; x < graph.width; ++x) {
            if (!wet(x, y)) continue;
            terrain.heights(x, y) = level - std::min(paths[graph.node(x, y)].cost, depth);
            terrain.water(x, y) = level;
        }
    }
    const std::vector<float> factors(
        shore.size(), static_cast<float>(water.shore_slope / options.mean_edge_weight));
    paths.spread(shore, ConstantGrowth{shore, factors});
    for (int y = 0; y < graph.height; ++y) {
        for (int x = 0; x < graph.width; ++x) {
            if (wet(x, y)) continue;
            const float rise = paths[graph.node(x, y)].cost;
            float& height = terrain.heights(x, y);
            height = std::clamp(height, level - rise, level + rise);
        }
    }
}

}  // namespace

void lay_water(Terrain& terrain, const Options& options, const Graph& graph) {
    if (options.water.empty()) return;
    if (terrain.water.empty()) {
        terrain.water = Field<float>(graph.width, graph.height, kDry);
    }
    LeastCost paths(graph);
    for (const Water& water : options.water) lay(terrain, water, options, graph, paths);
}

}  // namespace cydonia::distance
