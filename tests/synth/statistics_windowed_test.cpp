#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "field/noise.h"
#include "synth/statistics/windowed.h"

namespace cydonia::statistics {
namespace {

Terrain land(int width, int height) {
    Terrain terrain;
    terrain.heights = noise_field({}, width, height, 700.0, 3);
    for (float& value : terrain.heights) value += 4000.0f;
    terrain.spacing = 30.0;
    return terrain;
}

void expect_equals_brute_force(const Terrain& terrain, int radius) {
    const Field<float>& h = terrain.heights;
    const Windowed windows = windowed(terrain, radius);
    const auto slope = [&](int x, int y, int dx, int dy) {
        const int a = std::clamp(x + dx, 0, h.width() - 1),
                  b = std::clamp(y + dy, 0, h.height() - 1);
        const int c = std::clamp(x - dx, 0, h.width() - 1),
                  d = std::clamp(y - dy, 0, h.height() - 1);
        const int n = std::abs(a - c) + std::abs(b - d);
        return n > 0 ? (double(h(a, b)) - h(c, d)) / (n * terrain.spacing) : 0.0;
    };
    for (int y = 0; y < h.height(); ++y)
        for (int x = 0; x < h.width(); ++x) {
            double sum = 0.0, square = 0.0, east = 0.0, north = 0.0;
            float low = h(x, y), high = low;
            int n = 0;
            for (int q = y - radius; q <= y + radius; ++q)
                for (int p = x - radius; p <= x + radius; ++p) {
                    if (!h.contains(p, q)) continue;
                    ++n, sum += h(p, q);
                    low = std::min(low, h(p, q)), high = std::max(high, h(p, q));
                    east += slope(p, q, 1, 0), north += slope(p, q, 0, -1);
                }
            const double mean = sum / n;
            for (int q = y - radius; q <= y + radius; ++q)
                for (int p = x - radius; p <= x + radius; ++p)
                    if (h.contains(p, q)) square += (h(p, q) - mean) * (h(p, q) - mean);
            ASSERT_EQ(windows.low(x, y), low);
            ASSERT_EQ(windows.high(x, y), high);
            ASSERT_NEAR(windows.mean(x, y), mean, 1e-3);
            ASSERT_NEAR(windows.deviation(x, y), std::sqrt(square / n), 1e-3);
            ASSERT_NEAR(windows.east(x, y), east / n, 1e-5);
            ASSERT_NEAR(windows.north(x, y), north / n, 1e-5);
        }
}

TEST(Windowed, EqualsBruteForce) {
    for (const int radius : {0, 1, 4, 8}) expect_equals_brute_force(land(83, 70), radius);
}

TEST(Windowed, WiderThanTheLand) {
    expect_equals_brute_force(land(9, 6), 20);
    expect_equals_brute_force(land(1, 7), 2);
}

TEST(Windowed, LevelLand) {
    Terrain level;
    level.heights = Field<float>(40, 30, 8000.25f);
    const Windowed windows = windowed(level, 5);
    for (std::size_t i = 0; i < level.heights.size(); ++i) {
        ASSERT_EQ(windows.deviation[i], 0.0f);
        ASSERT_EQ(windows.mean[i], 8000.25f);
        ASSERT_EQ(windows.high[i], windows.low[i]);
    }
}

}  // namespace
}  // namespace cydonia::statistics
