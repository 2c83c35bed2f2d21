#include "synth/texture/synthesis/character.h"

#include <algorithm>
#include <cmath>

namespace cydonia::texture {
namespace {

float deviation(std::vector<float> values) {
    if (values.empty()) return 1.0f;
    double mean = 0.0, square = 0.0;
    for (const float v : values) mean += v;
    mean /= static_cast<double>(values.size());
    for (const float v : values) square += (v - mean) * (v - mean);
    const double d = std::sqrt(square / static_cast<double>(values.size()));
    return d > 0.0 ? static_cast<float>(d) : 1.0f;
}

// The mean step in height to the eastern and southern neighbours, over the cells under
// cell (x, y) of a level `ratio` times as coarse.
float mean_step(const Level& level, const Sheet& sheet, int ratio, int x, int y) {
    float steps = 0.0f;
    int count = 0;
    for (int j = ratio * y; j < std::min(sheet.height, ratio * (y + 1)); ++j)
        for (int i = ratio * x; i < std::min(sheet.width, ratio * (x + 1));
             ++i, ++count) {
            const float* h = &level.heights[sheet.index(i, j)];
            steps += std::abs(h[1] - h[0]) + std::abs(h[sheet.stride] - h[0]);
        }
    return steps / static_cast<float>(std::max(1, count));
}

}  // namespace

Character::Character(const Database& database, int level)
    : level_(level),
      of_(database.levels[std::size_t(level)]),
      heights_(of_.heights.begin(), of_.heights.end()),
      roughnesses_(heights_.size()) {
    const int finer = std::max(0, level - 2), ratio = 1 << (level - finer);
    const Level& fine = database.levels[std::size_t(finer)];
    std::vector<float> heights, roughnesses;  // of land
    for (std::size_t e = 0; e < of_.sheets.size(); ++e) {
        const Sheet& sheet = of_.sheets[e];
        for (int y = 0; y < sheet.height; ++y)
            for (int x = 0; x < sheet.width; ++x) {
                const std::size_t at = sheet.index(x, y);
                roughnesses_[at] = std::log(mean_step(fine, fine.sheets[e], ratio, x, y) +
                                            static_cast<float>(database.unit));
                if (!is_land(at)) continue;
                heights.push_back(heights_[at]);
                roughnesses.push_back(roughnesses_[at]);
            }
    }
    const float h = 1.0f / deviation(heights), r = 1.0f / deviation(roughnesses);
    for (float& height : heights_) height *= h;
    for (float& roughness : roughnesses_) roughness *= r;
}

}  // namespace cydonia::texture
