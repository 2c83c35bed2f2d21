#include "synth/genetic/map/map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <set>

#include "field/cells_inside.h"
#include "field/error.h"
#include "field/parallel.h"
#include "synth/genetic/map/outlines.h"

namespace cydonia::genetic {
namespace {

constexpr int kNobody = -1;
constexpr double kNarrow = 4.0;  // cells: too narrow for a gene to show the type

int type_called(const LibraryOptions& library, const std::string& name) {
    const auto found = std::ranges::find(library.types, name, &TypeOptions::name);
    return found == library.types.end() ? kNobody : int(found - library.types.begin());
}

// Calls put(column, row) for cells whose centres are inside an odd number of outlines.
void fill(const Drawn& drawn, const Extent& extent, const auto& put) {
    std::vector<std::vector<double>> crossings(std::size_t(extent.rows));
    const double s = extent.spacing, depth = extent.depth();
    // The first cell whose centre is not before `at`, at most `cells`.
    const auto first_from = [](double at, int cells) {
        return int(std::clamp(std::ceil(at), 0.0, double(cells)));
    };
    for (const auto& outline : drawn.outlines)
        for (std::size_t i = 0; i < outline.size(); ++i) {
            Point2 a = outline[i], b = outline[(i + 1) % outline.size()];
            // In rows, which count from the north.
            a[1] = (depth - a[1]) / s - 0.5, b[1] = (depth - b[1]) / s - 0.5;
            if (a[1] > b[1]) std::swap(a, b);
            const int last = first_from(b[1], extent.rows);
            for (int row = first_from(a[1], extent.rows); row < last; ++row)
                crossings[std::size_t(row)].push_back(
                    a[0] + (row - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
        }
    for (int row = 0; row < extent.rows; ++row) {
        auto& at = crossings[std::size_t(row)];
        std::ranges::sort(at);
        for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
            const int last = first_from(at[i + 1] / s - 0.5, extent.columns);
            for (int column = first_from(at[i] / s - 0.5, extent.columns); column < last;
                 ++column)
                put(column, row);
        }
    }
}

std::string percent(std::size_t cells, std::size_t of) {
    return fmt::format("{:.2g} %", 100.0 * double(cells) / double(of));
}

// The region of each cell, kNobody in gaps.
Field<int> owners_of(const std::vector<Drawn>& drawn, const MapOptions& map,
                     const Extent& extent, Progress& progress) {
    Field<int> owners(extent.columns, extent.rows, kNobody);
    std::map<std::pair<int, int>, std::size_t> overlaps;
    std::vector<std::size_t> own(drawn.size());
    for (std::size_t r = 0; r < drawn.size(); ++r)
        fill(drawn[r], extent, [&](int x, int y) {
            int& owner = owners(x, y);
            if (owner != kNobody) ++overlaps[{owner, int(r)}];
            owner = int(r), ++own[r];
        });
    // A region inside another, like an island in the sea, is intended.
    for (const auto& [pair, cells] : overlaps)
        if (cells < own[std::size_t(pair.second)])
            progress.warn(fmt::format("map: '{}' lies over '{}' on {} of the land",
                                      map.regions[std::size_t(pair.second)].name,
                                      map.regions[std::size_t(pair.first)].name,
                                      percent(cells, owners.size())));
    return owners;
}

// Gives each cell without a region to the nearest region. Labels spread in sweeps, each
// with the cell it came from (Danielsson 1980). OpenCV's distanceTransform gives labels
// with an approximate distance only, so borders would move.
void close_gaps(Field<int>& owners, Progress& progress) {
    const auto gaps = std::size_t(std::ranges::count(owners, kNobody));
    if (gaps == 0) return;
    progress.warn(
        fmt::format("map: {} of the land is in no region, and goes to the nearest one",
                    percent(gaps, owners.size())));
    const int w = owners.width(), h = owners.height();
    Field<std::array<int, 2>> from(w, h, {kNobody, kNobody});
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            if (owners(x, y) != kNobody) from(x, y) = {x, y};
    const auto square = [](double a) { return a * a; };
    const auto off = [&](int x, int y, const std::array<int, 2>& f) {
        return f[0] == kNobody ? 1e30 : square(x - f[0]) + square(y - f[1]);
    };
    const auto take = [&](int x, int y, int dx, int dy) {
        if (!from.contains(x + dx, y + dy)) return;
        if (off(x, y, from(x + dx, y + dy)) < off(x, y, from(x, y)))
            from(x, y) = from(x + dx, y + dy);
    };
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x)
            take(x, y, -1, 0), take(x, y, 0, -1), take(x, y, -1, -1), take(x, y, 1, -1);
        for (int x = w - 1; x >= 0; --x) take(x, y, 1, 0);
    }
    for (int y = h - 1; y >= 0; --y) {
        for (int x = w - 1; x >= 0; --x)
            take(x, y, 1, 0), take(x, y, 0, 1), take(x, y, 1, 1), take(x, y, -1, 1);
        for (int x = 0; x < w; ++x) take(x, y, -1, 0);
    }
    Field<int> closed = owners;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) closed(x, y) = owners(from(x, y)[0], from(x, y)[1]);
    owners = std::move(closed);
}

void add_transitions(Field<std::uint8_t>& types, const LibraryOptions& library,
                     double spacing) {
    const Field<std::uint8_t> drawn = types;
    for (const Transition& transition : library.transitions) {
        const int a = type_called(library, transition.a),
                  b = type_called(library, transition.b),
                  between = type_called(library, transition.type);
        if (a < 0 || b < 0 || between < 0) continue;
        // Marks cells of either type beside one of the other; what is near them becomes
        // the type between.
        Field<std::uint8_t> away(types.width(), types.height(), 1);
        bool any = false;
        const auto touch = [&](int x, int y, int i, int j) {
            if (!drawn.contains(i, j)) return;
            if ((drawn(x, y) == a && drawn(i, j) == b) ||
                (drawn(x, y) == b && drawn(i, j) == a))
                away(x, y) = away(i, j) = 0, any = true;
        };
        for (int y = 0; y < types.height(); ++y)
            for (int x = 0; x < types.width(); ++x)
                touch(x, y, x + 1, y), touch(x, y, x, y + 1);
        if (!any) continue;
        const Field<float> distances = cells_inside(away, true);
        for (std::size_t i = 0; i < types.size(); ++i)
            if ((drawn[i] == a || drawn[i] == b) &&
                (distances[i] + 0.5) * spacing <= 0.5 * transition.width)
                types[i] = std::uint8_t(between);
    }
}

// Connected components of land of one type, numbered by their first cells, row by row.
struct Components {
    Field<int> at;
    std::vector<MapRaster::Found> all;
};

Components components_of(const Field<std::uint8_t>& types) {
    Components components{Field<int>(types.width(), types.height(), kNobody), {}};
    const cv::Mat all(types.height(), types.width(), CV_8U,
                      const_cast<std::uint8_t*>(types.data()));
    const std::set<std::uint8_t> present(types.begin(), types.end());
    int labels_before = 0;
    for (const std::uint8_t type : present) {
        cv::Mat labels;
        const int count = cv::connectedComponents(all == type, labels, 4, CV_32S);
        for (int y = 0; y < types.height(); ++y)
            for (int x = 0; x < types.width(); ++x)
                if (types(x, y) == type)
                    components.at(x, y) = labels_before + labels.at<int>(y, x);
        labels_before += count;
    }
    // OpenCV numbers the components of each type separately and in its own order.
    std::vector<int> numbers(std::size_t(labels_before), kNobody);
    for (int y = 0; y < types.height(); ++y)
        for (int x = 0; x < types.width(); ++x) {
            int& number = numbers[std::size_t(components.at(x, y))];
            if (number == kNobody) {
                number = int(components.all.size());
                components.all.push_back(
                    {.type = types(x, y), .box = {x, y, x, y}, .inside = {x, y}});
            }
            components.at(x, y) = number;
            MapRaster::Found& found = components.all[std::size_t(number)];
            ++found.cells;
            found.box = {std::min(found.box[0], x), found.box[1],
                         std::max(found.box[2], x), y};
        }
    return components;
}

// Gives specks that a refined boundary cuts off to the land around them.
void drop_specks(Field<std::uint8_t>& types) {
    const Components components = components_of(types);
    constexpr std::size_t kSpeck = 4;  // cells
    for (int y = 0; y < types.height(); ++y)
        for (int x = 0; x < types.width(); ++x) {
            if (components.all[std::size_t(components.at(x, y))].cells >= kSpeck)
                continue;
            for (const auto [dx, dy] : {std::array{-1, 0}, {0, -1}, {1, 0}, {0, 1}})
                if (types.contains(x + dx, y + dy) &&
                    types(x + dx, y + dy) != types(x, y)) {
                    types(x, y) = types(x + dx, y + dy);
                    break;
                }
        }
}

// "'a', 'b' and 7 more"
std::string some_of(const std::vector<std::string>& all) {
    constexpr std::size_t kMost = 12;
    const std::size_t shown = std::min(all.size(), kMost);
    const auto more =
        all.size() > shown ? fmt::format(" and {} more", all.size() - shown) : "";
    return fmt::format("{}{}", fmt::join(all.begin(), all.begin() + long(shown), ", "),
                       more);
}

// Names each component after the drawn region that most of it belongs to.
void name_components(Components& components, const Field<int>& owners,
                     const MapOptions& map, const LibraryOptions& library,
                     Progress& progress) {
    std::vector<std::map<int, std::size_t>> counts(components.all.size());
    for (std::size_t i = 0; i < owners.size(); ++i)
        ++counts[std::size_t(components.at[i])][owners[i]];
    std::vector<int> times(map.regions.size());
    std::set<std::string> taken;
    std::vector<std::string> merged;
    for (std::size_t p = 0; p < components.all.size(); ++p) {
        MapRaster::Found& found = components.all[p];
        int most = kNobody;
        for (const auto& [owner, cells] : counts[p]) {
            const bool own_type =
                type_called(library, map.regions[std::size_t(owner)].type) == found.type;
            if (!own_type) continue;
            ++times[std::size_t(owner)];
            if (most == kNobody || cells > counts[p].at(most)) most = owner;
        }
        found.name = most == kNobody ? library.types[std::size_t(found.type)].name
                                     : map.regions[std::size_t(most)].name;
        const std::string plain = found.name;
        for (int n = 2; !taken.insert(found.name).second; ++n)
            found.name = fmt::format("{} {}", plain, n);
        std::size_t drawn = 0;
        for (const auto& [owner, cells] : counts[p])
            drawn +=
                type_called(library, map.regions[std::size_t(owner)].type) == found.type;
        if (drawn > 1) merged.push_back(fmt::format("{} into '{}'", drawn, found.name));
    }
    std::vector<std::string> vanished, split;
    for (std::size_t r = 0; r < times.size(); ++r) {
        if (times[r] == 1) continue;
        const std::string quoted = fmt::format("'{}'", map.regions[r].name);
        (times[r] == 0 ? vanished : split).push_back(quoted);
    }
    if (!merged.empty())
        progress.note("map: neighbours of one type are one region: " + some_of(merged));
    if (!vanished.empty())
        progress.note(fmt::format("map: {} regions have no cell of their own here: {}",
                                  vanished.size(), some_of(vanished)));
    if (!split.empty())
        progress.note(fmt::format("map: {} regions fall into several parts here: {}",
                                  split.size(), some_of(split)));
}

}  // namespace

MapRaster rasterised(const MapOptions& map, const LibraryOptions& library,
                     const Extent& extent, std::uint64_t seed, Progress& progress) {
    if (map.regions.empty())
        throw bad_request("the map has no regions; draw at least one");
    std::vector<std::uint8_t> types;
    for (const MapRegion& region : map.regions) {
        const int type = type_called(library, region.type);
        if (type == kNobody)
            throw bad_request("region '{}': the library has no type '{}'", region.name,
                              region.type);
        types.push_back(std::uint8_t(type));
    }
    Field<int> owners =
        owners_of(drawn_outlines(map, library, extent, seed), map, extent, progress);
    if (std::ranges::count(owners, kNobody) == std::ptrdiff_t(owners.size()))
        throw bad_request(
            "no region of the map lies in its window, {} to {} east and {} to {} north",
            map.window[0], map.window[2], map.window[1], map.window[3]);
    close_gaps(owners, progress);

    MapRaster raster;
    raster.types = Field<std::uint8_t>(extent.columns, extent.rows);
    for (std::size_t i = 0; i < owners.size(); ++i)
        raster.types[i] = types[std::size_t(owners[i])];
    add_transitions(raster.types, library, extent.spacing);
    drop_specks(raster.types);
    Components components = components_of(raster.types);
    name_components(components, owners, map, library, progress);

    raster.distances = Field<float>(extent.columns, extent.rows);
    std::vector<float> widest(components.all.size());
    const std::set<std::uint8_t> present(raster.types.begin(), raster.types.end());
    for (const std::uint8_t type : present) {
        Field<std::uint8_t> mask(extent.columns, extent.rows);
        std::ranges::transform(raster.types, mask.begin(),
                               [&](std::uint8_t t) { return t == type; });
        const Field<float> inside = cells_inside(mask, true);
        for (std::size_t i = 0; i < mask.size(); ++i)
            if (mask[i]) {
                // The distance from the cell's centre to the side of a cell of another
                // type.
                raster.distances[i] = float((inside[i] - 0.5) * extent.spacing);
                float& most = widest[std::size_t(components.at[i])];
                most = std::max(most, inside[i]);
            }
    }
    for (std::size_t p = 0; p < components.all.size(); ++p)
        if (widest[p] < kNarrow)
            progress.warn(
                fmt::format("map: '{}' is nowhere wider than {:.0f} samples of {:.4g} m: "
                            "smaller than "
                            "a gene, it will hardly be like its type",
                            components.all[p].name, 2.0f * widest[p], extent.spacing));
    raster.regions = std::move(components.at);
    raster.all = std::move(components.all);
    return raster;
}

}  // namespace cydonia::genetic
