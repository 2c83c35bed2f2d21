#include "synth/texture/database/pyramid.h"

#include <algorithm>
#include <queue>
#include <utility>

#include "field/parallel.h"
#include "field/random.h"

namespace cydonia::texture {
namespace {

// The means of 2x2 cells.
Field<float> halved(const Field<float>& fine) {
    const Size size = coarser_size({fine.width(), fine.height()});
    Field<float> coarse(size.width, size.height);
    const int right = fine.width() > 1, below = fine.height() > 1;
    parallel_for(coarse.height(), 16, [&](int y) {
        for (int x = 0; x < coarse.width(); ++x)
            coarse(x, y) =
                0.25f * (fine(2 * x, 2 * y) + fine(2 * x + right, 2 * y) +
                         fine(2 * x, 2 * y + below) + fine(2 * x + right, 2 * y + below));
    });
    return coarse;
}

// The most common type in each square of `side` by `side` cells of T^0 (section 5.2), and
// the first of equally common ones.
Field<std::uint8_t> majority(const Field<std::uint8_t>& types, int side, int width,
                             int height) {
    Field<std::uint8_t> result(width, height);
    parallel_for(height, 16, [&](int y) {
        for (int x = 0; x < width; ++x) {
            std::array<int, kMostTypes + 1> count{};  // the last: no type
            for (int v = side * y; v < std::min(side * (y + 1), types.height()); ++v)
                for (int u = side * x; u < std::min(side * (x + 1), types.width()); ++u)
                    ++count[std::min<std::size_t>(types(u, v), kMostTypes)];
            const auto most = std::ranges::max_element(count) - count.begin();
            result(x, y) = most == kMostTypes ? kNoType : static_cast<std::uint8_t>(most);
        }
    });
    return result;
}

// Sets kNowhere within 2.5 cells of voids, where appearance would describe interpolated
// land. A coarse cell is a void when at least a quarter of it is.
void close_voids(const Field<float>& void_share, Field<std::uint8_t>& types) {
    for (int y = 0; y < types.height(); ++y)
        for (int x = 0; x < types.width(); ++x) {
            if (void_share(x, y) < 0.25f) continue;
            for (int v = std::max(0, y - 2); v <= std::min(y + 2, types.height() - 1);
                 ++v)
                for (int u = std::max(0, x - 2); u <= std::min(x + 2, types.width() - 1);
                     ++u)
                    if ((u - x) * (u - x) + (v - y) * (v - y) <= 6)
                        types(u, v) = kNowhere;
        }
}

void close_borders(Field<std::uint8_t>& types, int border) {
    for (int y = 0; y < types.height(); ++y)
        for (int x = 0; x < types.width(); ++x)
            if (std::min({x, y, types.width() - 1 - x, types.height() - 1 - y}) < border)
                types(x, y) = kNowhere;
}

// One exemplar at one level.
struct Layer {
    Field<float> heights;
    Field<float> void_share;  // empty: no voids
    Field<std::uint8_t> types;
};

// Moves the heights out; the types are still needed for every level.
Layer first_layer(Land& land) {
    Layer layer{std::move(land.heights), {}, land.types};
    if (!land.voids.empty()) {
        layer.void_share = Field<float>(land.voids.width(), land.voids.height());
        std::ranges::copy(land.voids, layer.void_share.begin());
    }
    return layer;
}

Layer coarser(const Layer& fine, const Land& land, int level) {
    Layer layer;
    layer.heights = halved(fine.heights);
    if (!fine.void_share.empty()) layer.void_share = halved(fine.void_share);
    layer.types =
        majority(land.types, 1 << level, layer.heights.width(), layer.heights.height());
    return layer;
}

LevelArrays arrays_of(const std::vector<Layer>& layers, int index) {
    std::vector<Size> sizes;
    for (const Layer& layer : layers)
        sizes.push_back({layer.heights.width(), layer.heights.height()});
    LevelArrays level;
    level.sheets = sheets_of(sizes);
    const std::size_t cells = cells_of(level.sheets);
    level.heights.resize(cells);
    level.types.resize(cells, kNowhere);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const Sheet& sheet = level.sheets[i];
        Field<std::uint8_t> types = layers[i].types;
        if (!layers[i].void_share.empty()) close_voids(layers[i].void_share, types);
        close_borders(types, border_of(index));
        for (int y = 0; y < sheet.height; ++y) {
            std::ranges::copy(layers[i].heights.row(y),
                              &level.heights[sheet.index(0, y)]);
            std::ranges::copy(types.row(y), &level.types[sheet.index(0, y)]);
        }
        fill_guard(sheet, level.heights);
    }
    return level;
}

// A level is useful as long as some exemplar has about 4x4 usable cells.
bool has_land(const LevelArrays& level) {
    constexpr std::size_t kFewest = 16;
    return std::ranges::any_of(level.sheets, [&](const Sheet& sheet) {
        return places_of(level, sheet) >= kFewest;
    });
}

}  // namespace

Size coarser_size(Size fine) {
    return {std::max(1, fine.width / 2), std::max(1, fine.height / 2)};
}

std::vector<Sheet> sheets_of(std::span<const Size> sizes) {
    std::vector<Sheet> sheets;
    std::size_t cells = 0;
    for (const Size& size : sizes) {
        const int stride = size.width + 2 * kGuard;
        sheets.push_back({size.width, size.height, stride,
                          cells + std::size_t(kGuard) * std::size_t(stride) + kGuard});
        cells += std::size_t(stride) * std::size_t(size.height + 2 * kGuard);
    }
    return sheets;
}

std::size_t cells_of(const std::vector<Sheet>& sheets) {
    if (sheets.empty()) return 0;
    const Sheet& last = sheets.back();
    return last.index(last.width - 1 + kGuard, last.height - 1 + kGuard) + 1;
}

std::size_t places_of(const LevelArrays& level, const Sheet& sheet) {
    std::ptrdiff_t places = 0;
    for (int y = 0; y < sheet.height; ++y) {
        const std::uint8_t* row = &level.types[sheet.index(0, y)];
        places += sheet.width - std::count(row, row + sheet.width, kNowhere);
    }
    return static_cast<std::size_t>(places);
}

Level LevelArrays::view() const {
    Level level{sheets, heights, appearance, matches, types, last_sign, {}};
    level.seeds.assign(seeds.begin(), seeds.end());
    return level;
}

std::vector<LevelArrays> pyramid_of(std::vector<Land> lands, int most) {
    std::vector<Layer> layers;
    for (Land& land : lands) layers.push_back(first_layer(land));
    std::vector<LevelArrays> pyramid{arrays_of(layers, 0)};
    while (static_cast<int>(pyramid.size()) < std::min(most, kMostLevels)) {
        const int level = static_cast<int>(pyramid.size());
        for (std::size_t i = 0; i < lands.size(); ++i)
            layers[i] = coarser(layers[i], lands[i], level);
        LevelArrays next = arrays_of(layers, static_cast<int>(pyramid.size()));
        if (!has_land(next)) break;
        pyramid.push_back(std::move(next));
    }
    return pyramid;
}

void sow(LevelArrays& level, int types) {
    // For each type the cells with the smallest hashes, the largest of them on top.
    using Chosen = std::priority_queue<std::pair<std::uint64_t, std::uint64_t>>;
    std::vector<Chosen> chosen(static_cast<std::size_t>(types));
    for (std::uint64_t e = 0; e < level.sheets.size(); ++e) {
        const Sheet& sheet = level.sheets[e];
        for (int y = 0; y < sheet.height; ++y)
            for (int x = 0; x < sheet.width; ++x) {
                const std::size_t type = level.types[sheet.index(x, y)];
                if (type >= chosen.size()) continue;
                const std::uint64_t place =
                    e << 48 | std::uint64_t(y) << 24 | std::uint64_t(x);
                chosen[type].emplace(hash_of({key("seed"), place}), place);
                if (chosen[type].size() > kSeeds) chosen[type].pop();
            }
    }
    level.seeds.assign(chosen.size(), {});
    for (std::size_t type = 0; type < chosen.size(); ++type)
        for (; !chosen[type].empty(); chosen[type].pop())
            level.seeds[type].push_back(chosen[type].top().second);
}

}  // namespace cydonia::texture
