#include "render/maps/hillshade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "field/parallel.h"
#include "field/sun.h"

namespace cydonia::render {

namespace {

struct Slope {
    float east, north;  // rise per metre
};

// The slope after Horn 1981: central differences, with the neighbouring rows and columns
// at half weight. Heights at the edge repeat.
Field<Slope> slopes(const Field<float>& heights, double spacing) {
    const int w = heights.width(), h = heights.height();
    Field<Slope> result(w, h);
    const double scale = 1.0 / (8.0 * spacing);
    parallel_for(h, 16, [&](int y) {
        const int north = std::max(y - 1, 0), south = std::min(y + 1, h - 1);
        for (int x = 0; x < w; ++x) {
            const int west = std::max(x - 1, 0), east = std::min(x + 1, w - 1);
            const auto sum = [&](int x0, int y0, int x1, int y1, int x2, int y2) {
                return static_cast<double>(heights(x0, y0)) + 2.0 * heights(x1, y1) +
                       heights(x2, y2);
            };
            result(x, y) = {
                static_cast<float>(scale * (sum(east, north, east, y, east, south) -
                                            sum(west, north, west, y, west, south))),
                static_cast<float>(scale * (sum(west, north, x, north, east, north) -
                                            sum(west, south, x, south, east, south)))};
        }
    });
    return result;
}

// The factor that brings the 90th percentile of the slope to 40 degrees.
double exaggeration(const Field<Slope>& slopes) {
    std::vector<float> steepness(slopes.size());
    std::transform(slopes.begin(), slopes.end(), steepness.begin(),
                   [](Slope s) { return std::hypot(s.east, s.north); });
    const auto ninth = steepness.begin() + static_cast<std::ptrdiff_t>(
                                               0.9 * static_cast<double>(slopes.size()));
    std::nth_element(steepness.begin(), ninth, steepness.end());
    return std::clamp(
        std::tan(radians(40.0)) / std::max(1e-6, static_cast<double>(*ninth)), 0.2, 5.0);
}

struct Lamp {
    Vec3 direction;
    double weight;
};

const std::array<Lamp, 4> kLamps{{
    {direction_to({radians(315.0), radians(40.0)}), 0.60},
    {direction_to({radians(265.0), radians(50.0)}), 0.12},
    {direction_to({radians(5.0), radians(50.0)}), 0.08},
    {{0.0, 0.0, 1.0}, 0.20},
}};

// Low, middle and high land.
constexpr std::array<std::array<double, 3>, 3> kTints{
    {{112, 122, 108}, {196, 182, 152}, {246, 243, 238}}};

double tint(double height, int channel) {
    const double at = std::clamp(2.0 * height, 0.0, 2.0);
    const int lower = at < 1.0 ? 0 : 1;
    const double t = at - lower;
    return (1.0 - t) * kTints[lower][channel] + t * kTints[lower + 1][channel];
}

// Shallow and deep water.
constexpr std::array<std::array<double, 3>, 2> kWaterTints{
    {{128, 164, 180}, {38, 66, 98}}};

struct Water {
    Field<float> depth, share;  // metres; the share of a pixel under water. Both empty
                                // when there is no water
    float deepest = 0.0f;
    bool any() const { return deepest > 0.0f; }
};

Water water_of(const Terrain& terrain, int longest) {
    if (terrain.water.empty()) return {};
    const Field<float> depths = water_depths(terrain);
    Field<float> wet(depths.width(), depths.height());
    std::ranges::transform(depths, wet.begin(),
                           [](float depth) { return depth > 0.0f ? 1.0f : 0.0f; });
    return {at_most(depths, longest), at_most(wet, longest),
            *std::ranges::max_element(depths)};
}

// The colour of water, darker with depth, with a little of the relief of its bed.
double water_tint(const Water& water, std::size_t i, double shade, int channel) {
    const double down = std::sqrt(water.depth[i] / water.deepest);
    const double colour = kWaterTints[0][channel] +
                          down * (kWaterTints[1][channel] - kWaterTints[0][channel]);
    return colour * (0.75 + 0.35 * shade);
}

struct Range {
    double base, range;
};

// The range of the dry land, over which the tints are spread.
Range dry_range(const Field<float>& land, const Water& water) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t i = 0; i < land.size(); ++i) {
        if (water.any() && water.share[i] > 0.5f) continue;
        low = std::min<double>(low, land[i]);
        high = std::max<double>(high, land[i]);
    }
    return {low, std::max(1e-6, high - low)};
}

}  // namespace

Field<float> relief(const Field<float>& heights, double spacing) {
    if (heights.empty()) return {};
    const Field<Slope> rise = slopes(heights, spacing);
    const double steeper = exaggeration(rise);
    Field<float> result(heights.width(), heights.height());
    parallel_for(heights.height(), 16, [&](int y) {
        for (int x = 0; x < heights.width(); ++x) {
            const Vec3 normal = normalized(
                {-steeper * rise(x, y).east, -steeper * rise(x, y).north, 1.0});
            double light = 0.0;
            for (const Lamp& lamp : kLamps)
                light += lamp.weight * std::max(0.0, dot(normal, lamp.direction));
            result(x, y) = static_cast<float>(std::min(light, 1.0));
        }
    });
    return result;
}

Field<Rgb8> hillshade(const Terrain& terrain, int longest) {
    const Field<float> land = at_most(terrain.heights, longest);
    if (land.empty()) return {};
    const Field<float> shade = relief(land, terrain.width() / land.width());
    const Water water = water_of(terrain, longest);
    const auto [base, range] = dry_range(land, water);
    Field<Rgb8> result(land.width(), land.height());
    for (std::size_t i = 0; i < land.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            double value = tint((land[i] - base) / range, c) * (0.15 + shade[i]);
            if (water.any())
                value += water.share[i] * (water_tint(water, i, shade[i], c) - value);
            result[i][c] = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
        }
    return result;
}

}  // namespace cydonia::render
