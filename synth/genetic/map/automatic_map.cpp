#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/error.h"
#include "field/random.h"
#include "synth/genetic/map/boundary.h"
#include "synth/genetic/map/map.h"

namespace cydonia::genetic {
namespace {

constexpr int kRelaxations = 3;  // rounds of Lloyd's algorithm
constexpr int kWaves = 4;

// The part of a convex polygon that is nearer to `own` than to `other`.
std::vector<Point2> nearer(const std::vector<Point2>& polygon, const Point2& own,
                           const Point2& other) {
    const double nx = other[0] - own[0], ny = other[1] - own[1];
    const double limit = 0.5 * (nx * (own[0] + other[0]) + ny * (own[1] + other[1]));
    const auto beyond = [&](const Point2& p) { return nx * p[0] + ny * p[1] - limit; };
    std::vector<Point2> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = beyond(a), db = beyond(b);
        if (da <= 0.0) result.push_back(a);
        if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0)) {
            const double t = da / (da - db);
            result.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
        }
    }
    return result;
}

std::vector<std::vector<Point2>> voronoi(const std::vector<Point2>& sites, double width,
                                         double depth) {
    std::vector<std::vector<Point2>> cells;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        std::vector<Point2> cell = {
            {0.0, 0.0}, {width, 0.0}, {width, depth}, {0.0, depth}};
        for (std::size_t j = 0; j < sites.size() && !cell.empty(); ++j)
            if (j != i) cell = nearer(cell, sites[i], sites[j]);
        cells.push_back(std::move(cell));
    }
    return cells;
}

double area_of(const std::vector<Point2>& cell) {
    double twice = 0.0;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const Point2 &a = cell[i], &b = cell[(i + 1) % cell.size()];
        twice += a[0] * b[1] - b[0] * a[1];
    }
    return 0.5 * twice;
}

Point2 middle_of(const std::vector<Point2>& cell) {
    double area = 0.0, x = 0.0, y = 0.0;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const Point2 &a = cell[i], &b = cell[(i + 1) % cell.size()];
        const double cross = a[0] * b[1] - b[0] * a[1];
        area += cross, x += (a[0] + b[0]) * cross, y += (a[1] + b[1]) * cross;
    }
    return {x / (3.0 * area), y / (3.0 * area)};
}

}  // namespace

MapOptions automatic_map(const LibraryOptions& library, const std::vector<double>& means,
                         int regions, const Extent& extent, std::uint64_t seed) {
    std::vector<std::size_t> types;
    for (std::size_t t = 0; t < means.size(); ++t)
        if (!std::isnan(means[t])) types.push_back(t);
    if (types.empty()) throw bad_request("no type of the library has samples");
    std::ranges::stable_sort(types, {}, [&](std::size_t t) { return means[t]; });

    const double width = extent.width(), depth = extent.depth();
    std::vector<Point2> sites;
    for (int i = 0; i < regions; ++i) {
        const std::uint64_t h = hash_of({seed, key("site"), std::uint64_t(i)});
        sites.push_back({unit(h) * width, unit(mix(h)) * depth});
    }
    for (int i = 0; i < kRelaxations; ++i) {
        const auto cells = voronoi(sites, width, depth);
        for (std::size_t s = 0; s < sites.size(); ++s)
            if (cells[s].size() >= 3) sites[s] = middle_of(cells[s]);
    }
    const auto cells = voronoi(sites, width, depth);

    // Regions are ranked by the height of a smooth land of a few long waves, so that
    // neighbours get similar types and every type gets the same area.
    const auto lie = [&](const Point2& p) {
        double sum = 0.0;
        for (int k = 0; k < kWaves; ++k) {
            const std::uint64_t h = hash_of({seed, key("wave"), std::uint64_t(k)});
            const double way = 2.0 * std::numbers::pi * unit(h),
                         phase = 2.0 * std::numbers::pi * unit(mix(h)),
                         length = std::max(width, depth) / (0.5 + 0.4 * k);
            sum += std::sin(2.0 * std::numbers::pi *
                                (std::cos(way) * p[0] + std::sin(way) * p[1]) / length +
                            phase) /
                   (1.0 + k);
        }
        return sum;
    };
    std::vector<std::size_t> order(sites.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return lie(sites[i]); });

    MapOptions map;
    map.window = {0.0, 0.0, width, depth};
    map.regions.resize(sites.size());
    double below = 0.0;  // area of the regions that are lower, as a share of all
    for (const std::size_t site : order) {
        const double share = area_of(cells[site]) / (width * depth);
        const auto rank = std::size_t((below + 0.5 * share) * double(types.size()));
        below += share;
        const std::string& type =
            library.types[types[std::min(rank, types.size() - 1)]].name;
        map.regions[site] = {fmt::format("{} {}", type, site + 1), type, {cells[site]}};
    }
    std::erase_if(map.regions,
                  [](const MapRegion& r) { return r.outlines.front().size() < 3; });
    return map;
}

}  // namespace cydonia::genetic
