#include "synth/statistics/windows.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"
#include "synth/statistics/measures.h"

namespace cydonia::statistics {
namespace {

constexpr double kEnough = 0.4;  // share of a window that must be inside

// Calls visit(sample, number) for each number of each quantity.
template <class Visit>
void for_numbers(const Measures& measures, Quantity quantity, const Visit& visit) {
    for (const auto& [its, field] : measures.fields)
        for (std::size_t i = 0; its == quantity && i < field.size(); ++i)
            if (std::isfinite(field[i])) visit(i, field[i]);
    for (const Measures::Kind& kind : measures.kinds)
        for (const auto& [its, number] : kind.numbers)
            if (its == quantity)
                for (const Feature& feature : kind.features)
                    for (const std::uint32_t i : feature.samples)
                        visit(i, feature.*number);
}

}  // namespace

Field<Analysis> window_analyses(const Terrain& terrain,
                                const Field<std::uint8_t>& inside) {
    const int w = terrain.heights.width(), h = terrain.heights.height();
    const Measures measures = measures_of(terrain);
    Field<Analysis> result((w + kBlock - 1) / kBlock, (h + kBlock - 1) / kBlock);
    parallel_for(kQuantities, [&](int q) {
        double about = 0.0;
        std::size_t count = 0;
        for_numbers(measures, Quantity(q),
                    [&](std::size_t, float value) { about += value, ++count; });
        about /= double(std::max<std::size_t>(1, count));
        Field<Moments> blocks(result.width(), result.height());
        for_numbers(measures, Quantity(q), [&](std::size_t i, float value) {
            if (!inside.empty() && !inside[i]) return;
            blocks(int(i % std::size_t(w)) / kBlock, int(i / std::size_t(w)) / kBlock)
                .add(value, about);
        });
        for (int y = 0; y < result.height(); ++y)
            for (int x = 0; x < result.width(); ++x) {
                Moments sum;
                const int x0 = std::max(0, x - kBlocks / 2),
                          y0 = std::max(0, y - kBlocks / 2);
                const int x1 = std::min(result.width() - 1, x + kBlocks / 2),
                          y1 = std::min(result.height() - 1, y + kBlocks / 2);
                for (int j = y0; j <= y1; ++j)
                    for (int i = x0; i <= x1; ++i) sum += blocks(i, j);
                result(x, y)[std::size_t(q)] = sum.statistics(about);
            }
    });
    // At sides and corners windows are cut, and a share of what is left is enough.
    for (Analysis& analysis : result)
        if (double(analysis[std::size_t(Quantity::kElevation)].count) <
            kEnough * kBlock * kBlock * kBlocks * (kBlocks / 2 + 1))
            analysis = {};
    return result;
}

}  // namespace cydonia::statistics
