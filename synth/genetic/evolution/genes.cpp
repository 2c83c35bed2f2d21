#include "synth/genetic/evolution/genes.h"

#include <algorithm>
#include <cmath>

#include "synth/statistics/edges.h"

namespace cydonia::genetic {
namespace {

// Bits of Gene::turn.
constexpr int kSwapped = 1, kWestward = 2, kNorthward = 4;
constexpr double kFade = 1.5;  // cells: how far types fade into each other
constexpr float kNothing = 0.01f;

}  // namespace

Layout layout_of(const Gene& gene, int side, int stride) {
    const std::ptrdiff_t column = gene.turn & kWestward ? -1 : 1,
                         row = gene.turn & kNorthward ? -stride : stride;
    const std::ptrdiff_t x = gene.x + (gene.turn & kWestward ? side - 1 : 0),
                         y = gene.y + (gene.turn & kNorthward ? side - 1 : 0);
    Layout layout{y * stride + x, column, row};
    if (gene.turn & kSwapped) std::swap(layout.east, layout.south);
    return layout;
}

Gene continued(const Gene& from, int from_side, int ratio, int dx, int dy, int side) {
    if (from.turn & kSwapped) std::swap(dx, dy);
    Gene gene = from;
    const int far = ratio * from_side - side;
    gene.x = ratio * from.x + (from.turn & kWestward ? far - dx : dx);
    gene.y = ratio * from.y + (from.turn & kNorthward ? far - dy : dy);
    return gene;
}

Gene kept_inside(Gene gene, int side, const Sample& sample) {
    gene.x = std::clamp(gene.x, 0, sample.width() - side);
    gene.y = std::clamp(gene.y, 0, sample.height() - side);
    return gene;
}

GeneGrid grid_of(const Field<std::uint8_t>& types, int side, int overlap) {
    GeneGrid grid;
    grid.width = types.width(), grid.height = types.height();
    grid.side = side, grid.overlap = overlap;
    const auto count = [&](int cells) {
        return std::max(1, (cells - overlap + grid.step() - 1) / grid.step());
    };
    grid.columns = count(grid.width), grid.rows = count(grid.height);

    std::array<bool, 256> used{};
    for (const std::uint8_t type : types) used[type] = true;
    for (int type = 0; type < 256; ++type)
        if (used[std::size_t(type)]) grid.types.push_back(type);
    for (const int type : grid.types) {
        Field<float> weight(grid.width, grid.height);
        std::ranges::transform(types, weight.begin(),
                               [&](std::uint8_t t) { return t == type ? 1.0f : 0.0f; });
        if (grid.types.size() > 1) weight = statistics::blurred(weight, kFade);
        for (float& w : weight)
            if (w < kNothing) w = 0.0f;
        grid.weights.push_back(std::move(weight));
    }
    for (std::size_t i = 0; i < types.size(); ++i) {
        float sum = 0.0f;
        for (const auto& weight : grid.weights) sum += weight[i];
        for (auto& weight : grid.weights) weight[i] /= sum;
    }
    for (std::size_t layer = 0; layer < grid.types.size(); ++layer) {
        Field<std::int32_t> at(grid.columns, grid.rows, -1);
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) {
                const int x0 = column * grid.step(), y0 = row * grid.step();
                const int x1 = std::min(x0 + side, grid.width),
                          y1 = std::min(y0 + side, grid.height);
                bool any = false;
                for (int y = y0; y < y1 && !any; ++y)
                    any = std::any_of(grid.weights[layer].row(y).begin() + x0,
                                      grid.weights[layer].row(y).begin() + x1,
                                      [](float w) { return w > 0.0f; });
                if (!any) continue;
                at(column, row) = int(grid.slots.size());
                grid.slots.push_back(
                    {std::uint8_t(layer), std::int16_t(column), std::int16_t(row)});
            }
        grid.at.push_back(std::move(at));
    }
    return grid;
}

}  // namespace cydonia::genetic
