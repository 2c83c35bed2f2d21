#include "synth/texture/database/appearance.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"

namespace cydonia::texture {
namespace {

// Heights are counted in quarters of the unit, so that sums with Modes::kOne fit into 32
// bits.
constexpr int kParts = 4;

std::vector<std::int32_t> quarters_of(const LevelArrays& level,
                                      const HeightScale& scale) {
    std::vector<std::int32_t> quarters(level.heights.size());
    const double factor = kParts / scale.unit;
    std::ranges::transform(level.heights, quarters.begin(), [&](float height) {
        return static_cast<std::int32_t>(std::lround((height - scale.datum) * factor));
    });
    return quarters;
}

// Rounds halves away from zero, so that a negated pattern gives the negated value.
std::int16_t in_units(std::int32_t sum) {
    constexpr std::int32_t kUnit = kParts * Modes::kOne;
    const std::int32_t size =
        std::abs(sum) / kUnit + (std::abs(sum) % kUnit >= kUnit / 2);
    return static_cast<std::int16_t>(sum < 0 ? -size : size);
}

}  // namespace

void add_appearance(LevelArrays& level, const Modes& modes, const HeightScale& scale) {
    level.last_sign = modes.last_sign;
    level.appearance.resize(level.heights.size());
    const std::vector<std::int32_t> quarters = quarters_of(level, scale);
    for (const Sheet& sheet : level.sheets) {
        parallel_for(sheet.height, 8, [&](int y) {
            for (int x = 0; x < sheet.width; ++x) {
                std::array<std::int32_t, 4> sums{};
                for (int i = 0; i < 25; ++i) {
                    const std::size_t from = sheet.index(x + i % 5 - 2, y + i / 5 - 2);
                    const std::int32_t h = quarters[from];
                    for (std::size_t m = 0; m < 4; ++m)
                        sums[m] += h * modes.weights[m][std::size_t(i)];
                }
                for (std::size_t m = 0; m < 4; ++m)
                    level.appearance[sheet.index(x, y)][m] = in_units(sums[m]);
            }
        });
        fill_guard(sheet, level.appearance);
    }
}

}  // namespace cydonia::texture
