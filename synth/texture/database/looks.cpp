#include "synth/texture/database/looks.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"
#include "synth/texture/database/window_sums.h"

namespace cydonia::texture {
namespace {

constexpr std::array<int, 3> kRadii{2, 5, 12};  // of the windows, blocks
static_assert(3 * kRadii.size() == std::tuple_size_v<Look>);
constexpr float kCalm = 0.02f;   // rise over run: gentler slopes are all equally calm
constexpr float kLevel = 1e-4f;  // rise over run of water, even with rounded heights

// Blocks of kBlock by kBlock cells: their mean height and mean steepness.
struct Blocks {
    Field<float> heights, slopes;
};

Blocks blocks_of(const Field<float>& land, double spacing) {
    const int width = (land.width() + kBlock - 1) / kBlock;
    const int height = (land.height() + kBlock - 1) / kBlock;
    Blocks blocks{{width, height}, {width, height}};
    const double middle = static_cast<double>(land(land.width() / 2, land.height() / 2));
    parallel_for(height, 4, [&](int by) {
        for (int bx = 0; bx < width; ++bx) {
            const int right = std::min(kBlock * (bx + 1), land.width());
            const int bottom = std::min(kBlock * (by + 1), land.height());
            double sum = 0.0, slope = 0.0;
            for (int y = kBlock * by; y < bottom; ++y)
                for (int x = kBlock * bx; x < right; ++x) {
                    const int east = std::min(x + 1, land.width() - 1);
                    const int south = std::min(y + 1, land.height() - 1);
                    const double here = static_cast<double>(land(x, y));
                    sum += here - middle;
                    slope += std::hypot(static_cast<double>(land(east, y)) - here,
                                        static_cast<double>(land(x, south)) - here);
                }
            const double cells = double(right - kBlock * bx) * (bottom - kBlock * by);
            blocks.heights(bx, by) = static_cast<float>(sum / cells);
            blocks.slopes(bx, by) = static_cast<float>(slope / cells / spacing);
        }
    });
    return blocks;
}

template <class Value>
Field<float> field_of(const Field<float>& like, const Value& value) {
    Field<float> result(like.width(), like.height());
    parallel_for(like.height(), 16, [&](int y) {
        for (int x = 0; x < like.width(); ++x)
            result(x, y) = static_cast<float>(value(x, y));
    });
    return result;
}

// Adds steepness, spread of heights and departure from the mean height over the windows
// of one radius. All are base-2 logarithms of a rise over a run.
void add_looks(const Blocks& blocks, double spacing, std::size_t scale,
               Field<Look>& looks) {
    const int radius = kRadii[scale];
    const double across = (2 * radius + 1) * kBlock * spacing;
    const WindowSums heights(blocks.heights), slopes(blocks.slopes);
    const Field<float> bends = field_of(blocks.heights, [&](int x, int y) {
        return std::abs(static_cast<double>(blocks.heights(x, y)) -
                        heights.mean(x, y, radius));
    });
    const Field<float> squares = field_of(blocks.heights, [&](int x, int y) {
        const double height = static_cast<double>(blocks.heights(x, y));
        return height * height;
    });
    const WindowSums bent(bends), squared(squares);
    const auto scaled = [](double rise) {
        return std::log2(static_cast<float>(rise) + kCalm);
    };
    parallel_for(looks.height(), 16, [&](int y) {
        for (int x = 0; x < looks.width(); ++x) {
            const double mean = heights.mean(x, y, radius);
            const double spread = squared.mean(x, y, radius) - mean * mean;
            float* look = looks(x, y).data() + 3 * scale;
            look[0] = scaled(slopes.mean(x, y, radius));
            look[1] = scaled(4.0 * std::sqrt(std::max(0.0, spread)) / across);
            look[2] = scaled(4.0 * bent.mean(x, y, radius) / across);
        }
    });
}

}  // namespace

Looks looks_of(const Field<float>& land, double spacing) {
    const Blocks blocks = blocks_of(land, spacing);
    Looks looks{{blocks.slopes.width(), blocks.slopes.height()},
                {blocks.slopes.width(), blocks.slopes.height()}};
    for (std::size_t scale = 0; scale < kRadii.size(); ++scale)
        add_looks(blocks, spacing, scale, looks.numbers);
    std::ranges::transform(blocks.slopes, looks.level.begin(),
                           [](float slope) { return slope < kLevel; });
    return looks;
}

}  // namespace cydonia::texture
