// Painted types: Gain, Merry and Marais 2015, section 5.2.

#include "synth/texture/types.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "field/error.h"
#include "field/parallel.h"
#include "field/strokes.h"
#include "synth/texture/database.h"

namespace cydonia::texture {
namespace {

constexpr double kMostCells = 1 << 26;  // of the finest guided level
constexpr int kMostDrawn = 1 << 24;     // pixels that the painting is drawn with
constexpr int kFinest = 1 << kFinestGuided;

// A picture's types, kNoType where it is not painted, on a grid it is stretched over.
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

// Unions of `factor` by `factor` cells. A cell of any type asks for nothing and is left
// out, else a thin band would be lost on coarse levels (notes.md, Gain 2015, 5).
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

// The terrain at the finest guided level, cells.
struct Cells {
    double across, down;  // exactly
    int width, height;    // whole ones that cover it
};

Cells cells_of(const Ground& ground) {
    const double cell = kFinest * ground.spacing;
    const double across = ground.width / cell, down = ground.depth / cell;
    if (!(across * down <= kMostCells))
        throw bad_request(
            "texture: types cannot be painted on {:.3g} x {:.3g} cells of the synthesis; "
            "make the terrain smaller or `spacing` larger",
            ground.width / ground.spacing, ground.depth / ground.spacing);
    return {across, down, std::max(1, static_cast<int>(std::ceil(across - 1e-6))),
            std::max(1, static_cast<int>(std::ceil(down - 1e-6)))};
}

// R of the finest guided level, from a painting drawn finer while memory allows.
Field<TypeSet> finest_sets(const Options& options, const Ground& ground) {
    const Cells cells = cells_of(ground);
    int detail = kFinest;
    while (detail > 1 && detail * detail * cells.across * cells.down > kMostDrawn)
        detail /= 2;
    const auto drawn = [&](double exact, int whole) {
        return std::clamp(static_cast<int>(std::lround(detail * exact)), 1,
                          detail * whole);
    };
    const Field<std::uint8_t> painted =
        types_in(*options.paint, options.types, drawn(cells.across, cells.width),
                 drawn(cells.down, cells.height));
    Field<TypeSet> sets(painted.width(), painted.height());
    std::ranges::transform(painted, sets.begin(), [](std::uint8_t type) {
        return type == kNoType ? kAnyType : TypeSet{1} << type;
    });
    return united(sets, detail, cells.width, cells.height);
}

}  // namespace

TypeMap::TypeMap(const Options& options, const Ground& ground, int levels) {
    if (!options.paint || levels <= kFinestGuided) return;
    assert(options.types.size() <= kMostTypes);
    levels_.push_back(finest_sets(options, ground));
    for (int level = kFinestGuided + 1; level < levels; ++level) {
        const Field<TypeSet>& finer = levels_.back();
        levels_.push_back(
            united(finer, 2, (finer.width() + 1) / 2, (finer.height() + 1) / 2));
    }
}

bool TypeMap::empty() const { return levels_.empty(); }

Field<TypeSet> TypeMap::sets(const Window& window) const {
    assert(window.level >= kFinestGuided);
    Field<TypeSet> result(window.width, window.height, kAnyType);
    const auto level = static_cast<std::size_t>(window.level - kFinestGuided);
    if (level >= levels_.size()) return result;
    const Field<TypeSet>& all = levels_[level];
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x)
            if (all.contains(window.x + x, window.y + y))
                result(x, y) = all(window.x + x, window.y + y);
    return result;
}

TypeSet TypeMap::asked() const {
    TypeSet asked = 0;
    if (!levels_.empty())
        for (const TypeSet set : levels_.back())
            if (set != kAnyType) asked |= set;
    return asked;
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
