#include "synth/genetic/evolution/by_texture.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/parallel.h"
#include "field/sample.h"
#include "synth/texture/database/database.h"
#include "synth/texture/synthesis/correction.h"
#include "synth/texture/synthesis/origins.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::genetic {
namespace {

constexpr int kSmooth = 2;  // radius over which a cell's offset is averaged, cells
constexpr int kLevels = 6;

// The texture method's orientation for a gene's turn.
int orientation_of(const Gene& gene) {
    const Layout layout = layout_of(gene, 1, 1 << 20);
    const auto step_of = [](std::ptrdiff_t stride) {
        return std::abs(stride) == 1 ? texture::Step{int(stride), 0}
                                     : texture::Step{0, stride > 0 ? 1 : -1};
    };
    for (int o = 0; o < 8; ++o)
        if (texture::turned(o, {1, 0}) == step_of(layout.east) &&
            texture::turned(o, {0, 1}) == step_of(layout.south))
            return o;
    return 0;
}

// Offsets in units of `unit` metres, averaged over a cell's neighbours of the same gene.
// So the offset of a gene's land changes slowly, and the land keeps its own shape.
Field<std::int32_t> smoothed_offsets(const Field<float>& offsets,
                                     const Field<int>& owners, double unit) {
    Field<std::int32_t> smoothed(offsets.width(), offsets.height());
    parallel_for(offsets.height(), 8, [&](int row) {
        for (int column = 0; column < offsets.width(); ++column) {
            double sum = 0.0;
            int count = 0;
            for (int y = std::max(0, row - kSmooth);
                 y <= std::min(offsets.height() - 1, row + kSmooth); ++y)
                for (int x = std::max(0, column - kSmooth);
                     x <= std::min(offsets.width() - 1, column + kSmooth); ++x)
                    if (owners(x, y) == owners(column, row))
                        sum += offsets(x, y), ++count;
            smoothed(column, row) = std::int32_t(std::lround(sum / count / unit));
        }
    });
    return smoothed;
}

}  // namespace

struct ByTexture::Parts {
    std::shared_ptr<const texture::Database> database;
    std::vector<int> exemplar_of;  // texture's exemplar for each example of used types
    std::vector<int> type_of;      // texture's type for each type of the library, or -1
    double spacing = 1.0;

    int level_of(double at) const {
        const int last = int(database->levels.size()) - 1;
        return std::clamp(int(std::lround(std::log2(at / spacing))), 0, last);
    }
    // The slot whose gene made the land at (x, y), in cells of the coarser level, where
    // the finest level has land of `type`.
    static int owner(const Encoded& coarse, double x, double y, int type);
    // The position on the exemplar of a gene's land at (x, y), which may lie outside it.
    texture::Spot land_of(const Encoded& coarse, int slot, double x, double y) const;
    // The origins and offsets of a level's cells, all of which are pinned.
    texture::PinnedRegion start(const Encoded& coarse, const texture::Window& window,
                                const Field<std::uint8_t>& types) const;
};

ByTexture::ByTexture(const LibraryOptions& library, const std::vector<std::uint8_t>& used,
                     double spacing, const std::filesystem::path& cache,
                     Progress& progress)
    : parts_(std::make_unique<Parts>()) {
    texture::Options options;
    options.spacing = spacing;
    options.levels = kLevels;
    parts_->spacing = spacing;
    parts_->type_of.resize(library.types.size(), -1);
    for (std::size_t t = 0; t < library.types.size(); ++t) {
        if (!used[t]) continue;
        parts_->type_of[t] = int(options.types.size());
        options.types.push_back({library.types[t].name, {}});
        for (const Example& example : library.types[t].examples) {
            texture::Exemplar exemplar = exemplar_of(example);
            exemplar.type = library.types[t].name;
            parts_->exemplar_of.push_back(int(options.exemplars.size()));
            options.exemplars.push_back(std::move(exemplar));
        }
    }
    parts_->database = texture::database_of(options, cache, progress);
}

ByTexture::~ByTexture() = default;

int ByTexture::Parts::owner(const Encoded& coarse, double x, double y, int type) {
    const GeneGrid& grid = *coarse.grid;
    const int cx = std::clamp(int(std::floor(x)), 0, grid.width - 1),
              cy = std::clamp(int(std::floor(y)), 0, grid.height - 1);
    int slot = -1;
    for (std::size_t layer = 0; layer < grid.types.size() && slot < 0; ++layer)
        if (grid.types[layer] == type) slot = coarse.genes->owner(int(layer), cx, cy);
    for (std::size_t layer = 0; layer < grid.types.size() && slot < 0; ++layer)
        slot = coarse.genes->owner(int(layer), cx, cy);
    return slot;
}

texture::Spot ByTexture::Parts::land_of(const Encoded& coarse, int slot, double x,
                                        double y) const {
    const GeneGrid& grid = *coarse.grid;
    const double own = coarse.samples->spacing;
    const auto& s = grid.slots[std::size_t(slot)];
    const Gene& gene = coarse.genes->gene(slot);
    const Sample& sample = coarse.samples->all[std::size_t(gene.sample)];
    // Relative to the gene's centre, which turns leave in place.
    const double dx = x - (s.column * grid.step() + 0.5 * grid.side),
                 dy = y - (s.row * grid.step() + 0.5 * grid.side);
    const int orientation = orientation_of(gene);
    const texture::Step e = texture::turned(orientation, {1, 0}),
                        d = texture::turned(orientation, {0, 1});
    const double sx =
        (gene.x + 0.5 * grid.side + e.x * dx + d.x * dy) * own + sample.west;
    const double sy =
        (gene.y + 0.5 * grid.side + e.y * dx + d.y * dy) * own + sample.north;
    return {exemplar_of[std::size_t(sample.example)], orientation,
            int(std::lround(2.0 * sx / spacing)), int(std::lround(2.0 * sy / spacing))};
}

texture::PinnedRegion ByTexture::Parts::start(const Encoded& coarse,
                                              const texture::Window& window,
                                              const Field<std::uint8_t>& types) const {
    const texture::Level& level = database->levels[std::size_t(window.level)];
    const double cell = std::ldexp(spacing, window.level);
    const double own = coarse.samples->spacing;
    texture::PinnedRegion pinned{Field<float>(window.width, window.height),
                                 Field<texture::Origin>(window.width, window.height),
                                 {}};
    Field<int> owners(window.width, window.height);
    Field<float> offsets(window.width, window.height);
    parallel_for(window.height, 8, [&](int row) {
        for (int column = 0; column < window.width; ++column) {
            // In cells of the genes' level. Beyond the land its border's genes are
            // continued.
            const double x = (window.x + column + 0.5) * cell / own,
                         y = (window.y + row + 0.5) * cell / own;
            // The type there on the finest level, which follows boundaries best.
            const int fx = std::clamp(int(x * own / spacing), 0, types.width() - 1),
                      fy = std::clamp(int(y * own / spacing), 0, types.height() - 1);
            const int slot = owner(coarse, x, y, types(fx, fy));
            texture::Spot spot = land_of(coarse, slot, x, y);
            const texture::Sheet& sheet = level.sheets[std::size_t(spot.exemplar)];
            spot = texture::kept_inside(spot, sheet, window.level);
            pinned.origins(column, row) = texture::origin_of(spot);
            owners(column, row) = slot;
            const float height = level.heights[sheet.index(spot.x >> (window.level + 1),
                                                           spot.y >> (window.level + 1))];
            offsets(column, row) =
                float(bilinear(*coarse.heights, x - 0.5, y - 0.5)) - height;
        }
    });
    pinned.offsets = smoothed_offsets(offsets, owners, database->unit);
    return pinned;
}

Field<float> ByTexture::refined(const Encoded& coarse, const Field<std::uint8_t>& types,
                                std::uint64_t seed, Progress& progress) const {
    const Parts& p = *parts_;
    const int level = p.level_of(coarse.samples->spacing);
    texture::Controls controls;
    controls.seed = seed;
    texture::Guidance guidance;
    guidance.types = [&](const texture::Window& w) {
        Field<texture::TypeSet> sets(w.width, w.height, texture::kAnyType);
        parallel_for(w.height, 8, [&](int row) {
            for (int column = 0; column < w.width; ++column) {
                const int side = 1 << w.level, x0 = (w.x + column) * side,
                          y0 = (w.y + row) * side;
                texture::TypeSet set = 0;
                for (int y = std::max(0, y0); y < std::min(y0 + side, types.height());
                     ++y)
                    for (int x = std::max(0, x0); x < std::min(x0 + side, types.width());
                         ++x)
                        set |= texture::TypeSet{1} << p.type_of[std::size_t(types(x, y))];
                if (set != 0) sets(column, row) = set;
            }
        });
        return sets;
    };
    guidance.pinned = [&](const texture::Window& w, int) {
        return w.level == level ? p.start(coarse, w, types) : texture::PinnedRegion{};
    };
    const texture::Window window =
        texture::Window{0, 0, 0, types.width(), types.height()}.grown(texture::kReadOut);
    const texture::Synthesis land =
        texture::synthesised(*p.database, controls, guidance, window, nullptr, progress);
    return texture::heights_of(*p.database, land);
}

}  // namespace cydonia::genetic
