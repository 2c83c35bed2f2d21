#include "synth/genetic/evolution/by_texture.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/parallel.h"
#include "field/sample.h"
#include "synth/texture/database/database.h"
#include "synth/texture/synthesis/correction.h"
#include "synth/texture/synthesis/places.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::genetic {
namespace {

constexpr int kSmooth = 2;  // cells around that a cell's offset is averaged over
constexpr int kLevels = 6;

// Texture's name for a gene's turn.
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

}  // namespace

struct ByTexture::Parts {
    std::shared_ptr<const texture::Database> database;
    std::vector<int> exemplar_of;  // of each example of used types
    std::vector<int> type_of;      // of each type of the library, texture's
    double spacing = 1.0;

    int level_of(double at) const {
        const int last = int(database->levels.size()) - 1;
        return std::clamp(int(std::lround(std::log2(at / spacing))), 0, last);
    }
    texture::Kept start(const Encoded& coarse, const texture::Window& window,
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

// Places and offsets of a level's cells, all of them to stay.
texture::Kept ByTexture::Parts::start(const Encoded& coarse,
                                      const texture::Window& window,
                                      const Field<std::uint8_t>& types) const {
    const texture::Level& level = database->levels[std::size_t(window.level)];
    const double cell = std::ldexp(spacing, window.level);
    const double own = coarse.samples->spacing, unit = database->unit;
    const GeneGrid& grid = *coarse.grid;
    texture::Kept kept{Field<float>(window.width, window.height),
                       Field<texture::Place>(window.width, window.height),
                       Field<std::int32_t>(window.width, window.height)};
    Field<int> owners(window.width, window.height);
    Field<float> offsets(window.width, window.height);
    parallel_for(window.height, 8, [&](int row) {
        for (int column = 0; column < window.width; ++column) {
            // In cells of the genes' level; beyond the land what its border goes on with.
            const double x = (window.x + column + 0.5) * cell / own,
                         y = (window.y + row + 0.5) * cell / own;
            const int cx = std::clamp(int(std::floor(x)), 0, grid.width - 1),
                      cy = std::clamp(int(std::floor(y)), 0, grid.height - 1);
            // The type there on the finest level, which boundaries follow best.
            const int fx = std::clamp(int(x * own / spacing), 0, types.width() - 1),
                      fy = std::clamp(int(y * own / spacing), 0, types.height() - 1);
            int slot = -1;
            for (std::size_t layer = 0; layer < grid.types.size() && slot < 0; ++layer)
                if (grid.types[layer] == types(fx, fy))
                    slot = coarse.genes->owner(int(layer), cx, cy);
            for (std::size_t layer = 0; layer < grid.types.size() && slot < 0; ++layer)
                slot = coarse.genes->owner(int(layer), cx, cy);
            const auto& s = grid.slots[std::size_t(slot)];
            const Gene& gene = coarse.genes->gene(slot);
            const Sample& sample = coarse.samples->all[std::size_t(gene.sample)];
            // From the gene's middle, where turns leave it.
            const double dx = x - (s.column * grid.step() + 0.5 * grid.side),
                         dy = y - (s.row * grid.step() + 0.5 * grid.side);
            const int orientation = orientation_of(gene);
            const texture::Step e = texture::turned(orientation, {1, 0}),
                                d = texture::turned(orientation, {0, 1});
            const double sx = (gene.x + 0.5 * grid.side + e.x * dx + d.x * dy) * own +
                              sample.west,
                         sy = (gene.y + 0.5 * grid.side + e.y * dx + d.y * dy) * own +
                              sample.north;
            texture::Spot spot{exemplar_of[std::size_t(sample.example)], orientation,
                               int(std::lround(2.0 * sx / spacing)),
                               int(std::lround(2.0 * sy / spacing))};
            const texture::Sheet& sheet = level.sheets[std::size_t(spot.exemplar)];
            spot = texture::kept_inside(spot, sheet, window.level);
            kept.places(column, row) = texture::place_of(spot);
            owners(column, row) = slot;
            const float height = level.heights[sheet.index(spot.x >> (window.level + 1),
                                                           spot.y >> (window.level + 1))];
            offsets(column, row) =
                float(bilinear(*coarse.heights, x - 0.5, y - 0.5)) - height;
        }
    });
    // What a gene's land is off changes slowly across it: its own shape is to stay.
    parallel_for(window.height, 8, [&](int row) {
        for (int column = 0; column < window.width; ++column) {
            double sum = 0.0;
            int count = 0;
            for (int y = std::max(0, row - kSmooth);
                 y <= std::min(window.height - 1, row + kSmooth); ++y)
                for (int x = std::max(0, column - kSmooth);
                     x <= std::min(window.width - 1, column + kSmooth); ++x)
                    if (owners(x, y) == owners(column, row))
                        sum += offsets(x, y), ++count;
            kept.offsets(column, row) = std::int32_t(std::lround(sum / count / unit));
        }
    });
    return kept;
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
    guidance.kept = [&](const texture::Window& w, int) {
        return w.level == level ? p.start(coarse, w, types) : texture::Kept{};
    };
    const texture::Window window =
        texture::Window{0, 0, 0, types.width(), types.height()}.grown(texture::kReadOut);
    const texture::Synthesis land =
        texture::synthesised(*p.database, controls, guidance, window, nullptr, progress);
    return texture::heights_of(*p.database, land);
}

}  // namespace cydonia::genetic
