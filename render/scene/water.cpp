#include "render/scene/water.h"

#include <algorithm>

#include "field/border.h"

namespace cydonia::render {
namespace {

// How far water stays under lower land beside it, in cells.
constexpr float kUnderLand = 0.02f;

// The highest level of water at a sample and its eight neighbours, or kDry.
float level_near(const Terrain& terrain, int x, int y) {
    float level = kDry;
    for (int j = y - 1; j <= y + 1; ++j) {
        for (int i = x - 1; i <= x + 1; ++i) {
            if (!terrain.heights.contains(i, j)) continue;
            const std::size_t sample = terrain.heights.index(i, j);
            if (water_depth(terrain, sample) > 0.0f) {
                level = std::max(level, terrain.water[sample]);
            }
        }
    }
    return level;
}

float surface_at(const Terrain& terrain, int x, int y) {
    const std::size_t sample = terrain.heights.index(x, y);
    if (water_depth(terrain, sample) > 0.0f) return terrain.water[sample];
    const auto under = kUnderLand * static_cast<float>(terrain.spacing);
    return std::min(level_near(terrain, x, y), terrain.heights[sample] - under);
}

std::optional<double> sea_of(const Terrain& terrain) {
    std::optional<double> lowest;
    on_border(terrain.heights, [&](int x, int y) {
        const std::size_t sample = terrain.heights.index(x, y);
        if (water_depth(terrain, sample) <= 0.0f) return;
        const double level = terrain.water[sample];
        lowest = std::min(lowest.value_or(level), level);
    });
    return lowest;
}

}  // namespace

std::optional<WaterSurface> water_surface(const Terrain& terrain) {
    if (terrain.water.empty()) return std::nullopt;
    const int width = terrain.heights.width(), height = terrain.heights.height();
    // The height where there is no water: low enough to keep the slopes down to it under
    // all land.
    const float none =
        std::ranges::min(terrain.heights) - static_cast<float>(terrain.spacing);
    Field<float> surface(width, height);
    bool any = false;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            surface(x, y) = std::max(none, surface_at(terrain, x, y));
            any = any || surface(x, y) > none;
        }
    }
    if (!any) return std::nullopt;
    return WaterSurface{quantised(surface), sea_of(terrain)};
}

}  // namespace cydonia::render
