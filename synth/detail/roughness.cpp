#include "synth/detail/roughness.h"

#include <algorithm>
#include <cmath>

#include "field/sampled.h"
#include "synth/detail/fractal.h"

namespace cydonia::detail {
namespace {

constexpr int kAround = 5;       // radius, cells
constexpr float kMost = 1.7f;    // largest gain
constexpr float kLevel = 1e-3f;  // metres: least roughness that an example counts with

}  // namespace

Field<float> roughness_of(const Field<float>& land, Filter filter) {
    const std::vector<Level> levels =
        decomposed(padded(land, divisible(filter, land.width(), 1),
                          divisible(filter, land.height(), 1)),
                   filter, 1);
    const Field<float>& coarse = levels[0].coarse;
    const Field<float> rest = subdivided(Field<float>(coarse.width(), coarse.height()),
                                         levels[0].details, filter);
    const Field<float> strength = strength_of(rest, kAround);
    Field<float> result(land.width(), land.height());
    for (int y = 0; y < land.height(); ++y)
        std::copy_n(strength.row(y).begin(), land.width(), result.row(y).begin());
    return result;
}

Field<float> gain_of(int width, int height, const Window& window, const Blocks& blocks,
                     std::span<const Match> matches, const Field<float>& land,
                     std::span<const Field<float>> examples, int finer) {
    Field<float> gain(land.width(), land.height());
    const int cell = 1 << finer;
    for (int y = 0; y < gain.height(); ++y)
        for (int x = 0; x < gain.width(); ++x) {
            // The centre of a cell among the blocks' cells.
            const int i = std::min(window.x + x * cell + cell / 2, blocks.width - 1),
                      j = std::min(window.y + y * cell + cell / 2, blocks.height - 1);
            const Match& match = matches[std::size_t(blocks.at(i, j))];
            if (match.example < 0) continue;
            const Field<float>& example = examples[std::size_t(match.example)];
            const int ex = std::clamp((i + match.dx) >> finer, 0, example.width() - 1),
                      ey = std::clamp((j + match.dy) >> finer, 0, example.height() - 1);
            gain(x, y) = std::min(kMost, land(x, y) / std::max(kLevel, example(ex, ey)));
        }
    if (finer == 0) return gain;
    gain = sampled(gain, {0.0, 0.0, 1.0 / cell}, width, height);
    for (float& g : gain) g = std::clamp(g, 0.0f, kMost);
    return gain;
}

}  // namespace cydonia::detail
