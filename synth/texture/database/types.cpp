// Painted types: Gain, Merry and Marais 2015, section 5.2.

#include "synth/texture/database/types.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "field/parallel.h"
#include "field/strokes.h"
#include "synth/texture/database/database.h"

namespace cydonia::texture {

using namespace geometry;

namespace {

constexpr double kMostCells = 1 << 24;  // of a level; also pixels of the painting

// The types of a picture that is stretched over a grid; kNoType where nothing is painted.
Field<std::uint8_t> types_in(const Source& picture, const std::vector<Type>& types,
                             int width, int height) {
    std::vector<std::array<std::uint8_t, 3>> palette;
    for (const Type& type : types) palette.push_back(type.colour);
    const Field<Rgba8> drawn = read_strokes(picture, width, height, palette);
    Field<std::uint8_t> result(width, height, kNoType);
    parallel_for(height, 16, [&](int y) {
        std::ranges::transform(drawn.row(y), result.row(y).begin(), [&](Rgba8 pixel) {
            if (pixel[3] == 0) return kNoType;
            const auto type = std::ranges::find(
                palette, std::array<std::uint8_t, 3>{pixel[0], pixel[1], pixel[2]});
            return static_cast<std::uint8_t>(type - palette.begin());
        });
    });
    return result;
}

// The unions of `factor` by `factor` cells. A cell of any type asks for nothing and is
// left out; otherwise a thin band would vanish on coarse levels (docs/papers.md, Gain
// 2015, 5).
Field<TypeSet> united(const Field<TypeSet>& sets, int factor, int width, int height) {
    Field<TypeSet> result(width, height, kAnyType);
    parallel_for(height, 16, [&](int y) {
        for (int x = 0; x < width; ++x) {
            TypeSet asked = 0;
            for (int j = factor * y; j < std::min(factor * (y + 1), sets.height()); ++j)
                for (int i = factor * x; i < std::min(factor * (x + 1), sets.width());
                     ++i)
                    if (sets(i, j) != kAnyType) asked |= sets(i, j);
            if (asked != 0) result(x, y) = asked;
        }
    });
    return result;
}

// R of a level, from a painting that is drawn finer than the level's cells as far as
// memory allows.
Field<TypeSet> sets_of(const Options& options, const Ground& ground, int level) {
    const double cell = std::ldexp(ground.spacing, level);
    const double across = ground.width / cell, down = ground.depth / cell;
    const auto whole = [](double cells) {
        return std::max(1, static_cast<int>(std::ceil(cells - 1e-6)));
    };
    int detail = 4;
    while (detail > 1 && detail * detail * across * down > kMostCells) detail /= 2;
    const auto drawn = [&](double cells) {
        return std::clamp(static_cast<int>(std::lround(detail * cells)), 1,
                          detail * whole(cells));
    };
    const Field<std::uint8_t> painted =
        types_in(*options.paint, options.types, drawn(across), drawn(down));
    Field<TypeSet> sets(painted.width(), painted.height());
    std::ranges::transform(painted, sets.begin(), [](std::uint8_t type) {
        return type == kNoType ? kAnyType : TypeSet{1} << type;
    });
    return united(sets, detail, whole(across), whole(down));
}

}  // namespace

TypeMap::TypeMap(const Options& options, const Ground& ground, int levels) {
    if (!options.paint || levels <= kFinestGuided) return;
    assert(options.types.size() <= kMostTypes);
    const double cells = ground.width / ground.spacing * ground.depth / ground.spacing;
    while (std::ldexp(cells, -2 * finest_) > kMostCells) ++finest_;
    levels_.push_back(sets_of(options, ground, finest_));
    for (int level = finest_ + 1; level < levels; ++level) {
        const Field<TypeSet>& finer = levels_.back();
        levels_.push_back(
            united(finer, 2, (finer.width() + 1) / 2, (finer.height() + 1) / 2));
    }
}

bool TypeMap::empty() const { return levels_.empty(); }

Field<TypeSet> TypeMap::sets(const Window& window) const {
    assert(window.level >= kFinestGuided);
    Field<TypeSet> result(window.width, window.height, kAnyType);
    const int level = std::max(window.level, finest_), shift = level - window.level;
    const auto index = static_cast<std::size_t>(level - finest_);
    if (index >= levels_.size()) return result;
    const Field<TypeSet>& all = levels_[index];
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x) {
            const int i = (window.x + x) >> shift, j = (window.y + y) >> shift;
            if (all.contains(i, j)) result(x, y) = all(i, j);
        }
    return result;
}

Field<std::uint8_t> painted_types(const Options& options, int index, int width,
                                  int height) {
    const Exemplar& exemplar = options.exemplars[static_cast<std::size_t>(index)];
    if (exemplar.types) return types_in(*exemplar.types, options.types, width, height);
    const auto type = std::ranges::find(options.types, exemplar.type, &Type::name);
    const bool typed = !exemplar.type.empty() && type != options.types.end();
    return {width, height,
            typed ? static_cast<std::uint8_t>(type - options.types.begin()) : kNoType};
}

}  // namespace cydonia::texture
