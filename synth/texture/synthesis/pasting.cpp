#include "synth/texture/synthesis/pasting.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "synth/texture/synthesis/origins.h"

namespace cydonia::texture {

using namespace geometry;

namespace {

// Whether a point is inside a polygon, by the even-odd rule.
bool in_polygon(const std::vector<std::array<double, 2>>& outline, double x, double y) {
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const auto& [ax, ay] = outline[i];
        const auto& [bx, by] = outline[j];
        if ((ay > y) != (by > y) && x < (bx - ax) * (y - ay) / (by - ay) + ax)
            inside = !inside;
    }
    return inside;
}

// The shape of a paste, in metres east and north of `from`. A paste without a shape is as
// large as its exemplar.
struct PasteShape {
    const Paste& paste;
    double radius;  // of a disc, metres; 0: a polygon or the whole exemplar
    double half_width, half_depth;  // of its bounding box, metres

    PasteShape(const Paste& p, const Ground& ground, double width, double depth)
        : paste(p), radius(p.radius.in(ground.width)) {
        half_width = half_depth = radius;
        if (radius == 0.0 && p.outline.empty()) {
            half_width = std::max(p.from[0], 1.0 - p.from[0]) * width;
            half_depth = std::max(p.from[1], 1.0 - p.from[1]) * depth;
        }
        for (const auto& [x, y] : p.outline) {
            half_width = std::max(half_width, std::abs(x));
            half_depth = std::max(half_depth, std::abs(y));
        }
    }
    bool holds(double x, double y) const {
        if (!paste.outline.empty()) return in_polygon(paste.outline, x, y);
        return radius == 0.0 || x * x + y * y <= radius * radius;
    }
};

// R of a region that is turned clockwise: steps on the terrain turn back by as much.
int orientation_of(const Paste& paste) {
    return ((4 - paste.turn) & 3) | (paste.mirror ? 4 : 0);
}

Field<std::uint8_t> grown(const Field<std::uint8_t>& inside, int cells) {
    Field<std::uint8_t> result(inside.width(), inside.height());
    for (int y = 0; y < inside.height(); ++y) {
        for (int x = 0; x < inside.width(); ++x) {
            if (!inside(x, y)) continue;
            const int x1 = std::min(x + cells, inside.width() - 1);
            const int y1 = std::min(y + cells, inside.height() - 1);
            for (int v = std::max(0, y - cells); v <= y1; ++v)
                for (int u = std::max(0, x - cells); u <= x1; ++u) result(u, v) = 1;
        }
    }
    return result;
}

}  // namespace

CellSet cell_set_of(const Window& window, Field<std::uint8_t> inside, int levels) {
    CellSet region;
    region.finest = window.level;
    region.layers.push_back({window, grown(inside, kReadOut)});
    for (int i = 1; i < levels; ++i) {
        const CellSet::Layer& fine = region.layers.back();
        CellSet::Layer coarse{fine.window.coarser(), {}};
        coarse.inside = {coarse.window.width, coarse.window.height};
        for (int y = 0; y < fine.window.height; ++y)
            for (int x = 0; x < fine.window.width; ++x)
                if (fine.inside(x, y))
                    coarse.inside(((fine.window.x + x) >> 1) - coarse.window.x,
                                  ((fine.window.y + y) >> 1) - coarse.window.y) = 1;
        region.layers.push_back(std::move(coarse));
    }
    return region;
}

Pasting::Pasting(const Options& options, const Database& database, const Ground& ground,
                 int finest, const Land& land)
    : database_(database), finest_(finest) {
    for (const Paste& paste : options.pastes) {
        Patch patch = patch_of(paste, ground);
        if (patch.exemplar == 0) {
            // Coarser cells at the region's border reach beyond it.
            const int cell = 2 << finest;
            const int beyond = 2
                               << (static_cast<int>(database.levels.size()) - 1 - finest);
            Window from = patch.region.layers.front().window.grown(beyond);
            from.x += patch.shift.x / cell;
            from.y += patch.shift.y / cell;
            patch.land = land(from);
        }
        patches_.push_back(std::move(patch));
    }
}

Pasting::Patch Pasting::patch_of(const Paste& paste, const Ground& ground) const {
    const double half = 0.5 * ground.spacing;  // half a cell of level 0, metres
    const int cell = 2 << finest_;
    double width = ground.width, depth = ground.depth;
    if (paste.exemplar > 0) {
        const Sheet& sheet = database_.levels[0].sheets[std::size_t(paste.exemplar - 1)];
        width = 2.0 * half * sheet.width;
        depth = 2.0 * half * sheet.height;
    }
    const PasteShape shape(paste, ground, width, depth);
    const int o = paste.exemplar > 0 ? orientation_of(paste) : 0;

    // Rounds to whole cells of the finest level, so that centres fall on centres.
    const auto whole = [&](double half_cells) {
        return static_cast<int>(std::lround(half_cells / cell)) * cell;
    };
    const double from_x = paste.from[0] * width / half;
    const double from_y = (1.0 - paste.from[1]) * depth / half;
    const double to_x = paste.to[0].in(ground.width) / half;
    const double to_y = (ground.depth - paste.to[1].in(ground.depth)) / half;
    const Step e = turned(o, {1, 0}), s = turned(o, {0, 1});
    Patch patch;
    patch.exemplar = paste.exemplar;
    patch.orientation = o;
    patch.shift = {whole(from_x - (e.x * to_x + s.x * to_y)),
                   whole(from_y - (e.y * to_x + s.y * to_y))};
    patch.raise = static_cast<std::int32_t>(std::lround(paste.raise / database_.unit));

    // The part on the terrain, and slightly more, so that its border stays exact.
    const bool across = e.x == 0;
    const double half_width = (across ? shape.half_depth : shape.half_width) / half;
    const double half_depth = (across ? shape.half_width : shape.half_depth) / half;
    constexpr int kBeyond = 2 * kReadOut + 2;
    const auto span = [&](double middle, double reach, double size) {
        const int first =
            static_cast<int>(std::floor(std::max(middle - reach, 0.0) / cell)) - kBeyond;
        const int last =
            static_cast<int>(std::ceil(std::min(middle + reach, size / half) / cell)) +
            kBeyond;
        if (last - first <= 2 * kBeyond)
            throw bad_request("texture: '{}' is put beside the terrain; let it lie on it",
                              paste.name);
        return std::array<int, 2>{first, last - first};
    };
    const auto [x, columns] = span(to_x, half_width, ground.width);
    const auto [y, rows] = span(to_y, half_depth, ground.depth);
    const Window window{finest_, x, y, columns, rows};
    Field<std::uint8_t> inside(columns, rows);
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const Step at = {(x + i) * cell + cell / 2, (y + j) * cell + cell / 2};
            const Step there = kTurns(o, at.x, at.y);
            inside(i, j) = shape.holds((there.x + patch.shift.x - from_x) * half,
                                       (from_y - there.y - patch.shift.y) * half);
        }
    }
    patch.region = cell_set_of(window, std::move(inside),
                               static_cast<int>(database_.levels.size()) - finest_);
    return patch;
}

bool Pasting::source(const Patch& patch, const Window& window, int x, int y, int pass,
                     Origin& place, std::int32_t& offset) const {
    const int cell = 2 << window.level;
    const Step there =
        kTurns(patch.orientation, x * cell + cell / 2, y * cell + cell / 2);
    const Step from{there.x + patch.shift.x, there.y + patch.shift.y};
    Spot spot{patch.exemplar - 1, patch.orientation, from.x, from.y};
    offset = 0;
    if (patch.exemplar == 0) {
        // The land of the cell that contains the position, at the same offset from the
        // cell's centre.
        const std::vector<Synthesis>& passes = patch.land[std::size_t(window.level)];
        const Synthesis& land = passes[std::min(std::size_t(pass), passes.size() - 1)];
        const int i = (from.x >> (window.level + 1)) - land.window.x;
        const int j = (from.y >> (window.level + 1)) - land.window.y;
        if (!land.origins.contains(i, j)) return false;
        const Spot own = spot_of(land.origins(i, j));
        const int beside_x = (from.x & (cell - 1)) - cell / 2;
        const int beside_y = (from.y & (cell - 1)) - cell / 2;
        spot = own.moved(kTurns(own.orientation, beside_x, beside_y));
        offset = land.offsets(i, j);
    }
    const Sheet& sheet =
        database_.levels[std::size_t(window.level)].sheets[std::size_t(spot.exemplar)];
    const Spot kept = kept_inside(spot, sheet, window.level);
    if (patch.exemplar > 0 && (kept.x != spot.x || kept.y != spot.y)) return false;
    place = origin_of(window.level <= finest_ + 1 ? Spot{kept.exemplar, kept.orientation,
                                                         snapped(kept.x, window.level),
                                                         snapped(kept.y, window.level)}
                                                  : kept);
    offset += patch.raise;
    return true;
}

void Pasting::lay_down(const Window& window, int pass, PinnedRegion& pinned) const {
    if (patches_.empty()) return;
    if (pinned.weights.empty())
        pinned = {{window.width, window.height, 1.0f},
                  {window.width, window.height},
                  {window.width, window.height}};
    for (const Patch& patch : patches_) {
        const CellSet::Layer& layer = patch.region.at(window.level);
        for (int row = 0; row < window.height; ++row) {
            for (int column = 0; column < window.width; ++column) {
                const int x = window.x + column, y = window.y + row;
                if (!layer.holds(x, y)) continue;
                const std::size_t i = pinned.origins.index(column, row);
                if (source(patch, window, x, y, pass, pinned.origins[i],
                           pinned.offsets[i]))
                    pinned.weights[i] = 0.0f;
            }
        }
    }
}

}  // namespace cydonia::texture
