#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "field/noise.h"
#include "synth/statistics/segmentation.h"
#include "synth/statistics/water.h"

namespace cydonia::statistics {
namespace {

Terrain land(double height, double h, std::uint64_t seed, int width = 240,
             int depth = 240) {
    NoiseOptions noise;
    noise.octaves = 6;
    noise.h = h;
    Terrain terrain;
    terrain.heights = noise_field(noise, width, depth, height, seed);
    terrain.spacing = 30.0;
    return terrain;
}

Terrain rough(std::uint64_t seed, int width = 240, int depth = 240) {
    return land(500.0, 0.7, seed, width, depth);
}
Terrain smooth(std::uint64_t seed, int width = 240, int depth = 240) {
    return land(400.0, 1.3, seed, width, depth);
}

Library two_lands() {
    std::vector<Type> types = {{"rough", {}}, {"smooth", {}}};
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        for (std::size_t t : {0u, 1u}) {
            const auto windows =
                spread_windows(window_analyses(t == 0 ? rough(seed) : smooth(seed + 10)));
            types[t].examples.insert(types[t].examples.end(), windows.begin(),
                                     windows.end());
        }
    return Library(std::move(types));
}

double share(const Field<int>& types, int type) {
    double count = 0.0;
    for (const int own : types) count += own == type;
    return count / double(types.size());
}

// Two lands, one blended into the other along a line: where it lies, and what is on
// either side.
TEST(Segmentation, FindsTheBorderOfTwoLands) {
    constexpr int kWide = 480, kDeep = 360;
    const Library library = two_lands();
    for (const double angle : {0.0, 0.5}) {
        Terrain both = rough(21, kWide, kDeep);
        const Terrain other = smooth(31, kWide, kDeep);
        const auto across = [&](int x, int y) {
            return (x - 0.5 * kWide) * std::cos(angle) +
                   (y - 0.5 * kDeep) * std::sin(angle);
        };
        for (int y = 0; y < kDeep; ++y)
            for (int x = 0; x < kWide; ++x) {
                const float u = float(std::clamp(across(x, y) / 8.0 + 0.5, 0.0, 1.0));
                both.heights(x, y) =
                    (1.0f - u) * both.heights(x, y) + u * other.heights(x, y);
            }
        const Field<int> types =
            sample_types(block_types(library, window_analyses(both)), kWide, kDeep);
        double right = 0.0, far = 0.0, far_right = 0.0;
        for (int y = 0; y < kDeep; ++y)
            for (int x = 0; x < kWide; ++x) {
                const bool as_made = types(x, y) == (across(x, y) > 0.0);
                right += as_made;
                if (std::abs(across(x, y)) > 0.5 * kBlock * kBlocks)
                    far += 1.0, far_right += as_made;
            }
        EXPECT_GT(right / (kWide * kDeep), 0.9) << angle;
        EXPECT_GT(far_right / far, 0.98) << angle;
    }
}

TEST(Segmentation, OneLandIsOneType) {
    const Library library = two_lands();
    const auto types = [&](const Terrain& terrain) {
        return sample_types(block_types(library, window_analyses(terrain)), 240, 240);
    };
    EXPECT_GT(share(types(rough(51)), 0), 0.95);
    EXPECT_GT(share(types(smooth(52)), 1), 0.95);
}

TEST(Segmentation, LeavesOutWhatIsNotInside) {
    const Terrain terrain = rough(61);
    Field<std::uint8_t> inside(240, 240, 1);
    for (int y = 0; y < 240; ++y)
        for (int x = 120; x < 240; ++x) inside(x, y) = 0;
    const Field<int> blocks = block_types(two_lands(), window_analyses(terrain, inside));
    EXPECT_NE(blocks(2, 10), kNoType);
    EXPECT_EQ(blocks(18, 10), kNoType);
}

TEST(Segmentation, ThreadsDoNotMatter) {
    const auto made = [] {
        return block_types(two_lands(), window_analyses(rough(81, 300, 200)));
    };
    Field<int> one;
    {
        const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
        one = made();
    }
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    EXPECT_EQ(one, made());
}

// Narrow, small and level land is no reason to stumble.
TEST(Segmentation, LandOfAnySize) {
    for (const auto& [w, h] : {std::pair{1, 1}, {2, 90}, {90, 2}, {49, 61}, {13, 13}}) {
        const Field<int> blocks =
            block_types(two_lands(), window_analyses(rough(1, w, h)));
        EXPECT_EQ(sample_types(blocks, w, h).width(), w);
        EXPECT_EQ(water_of(Field<float>(w, h)).size(), std::size_t(w * h));
    }
    EXPECT_EQ(block_types(Library({}), window_analyses(rough(1, 60, 60)))(2, 2), kNoType);
}

TEST(Segmentation, LargestRectangle) {
    Field<int> types(9, 7, 0);
    for (int y = 2; y < 6; ++y)
        for (int x = 3; x < 8; ++x) types(x, y) = 1;
    types(0, 0) = types(8, 4) = types(7, 2) = 1;
    types(7, 2) = 0;
    const Rectangle found = largest_rectangle(types, 1);
    EXPECT_EQ(found.area(), 16);
    EXPECT_EQ(found.x0, 3);
    EXPECT_EQ(found.y0, 2);
    EXPECT_EQ(found.x1, 7);
    EXPECT_EQ(found.y1, 6);
    EXPECT_EQ(largest_rectangle(types, 2).area(), 0);
    EXPECT_EQ(largest_rectangle(Field<int>(5, 4, 1), 1).area(), 20);
}

TEST(Water, IsFoundToTheSample) {
    Terrain terrain = rough(71);
    Field<std::uint8_t> made(240, 240);
    const auto fill = [&](double cx, double cy, double r, float height, bool is_water) {
        for (int y = 0; y < 240; ++y)
            for (int x = 0; x < 240; ++x)
                if (std::hypot(x - cx, y - cy) < r) {
                    terrain.heights(x, y) = height;
                    made(x, y) = is_water;
                }
    };
    fill(60, 70, 25.0, 312.5f, true);
    fill(239, 200, 30.0, 0.0f, true);   // cut by the side
    fill(150, 60, 5.0, 100.0f, false);  // a puddle
    EXPECT_EQ(water_of(terrain.heights), made);
}

// Level bands of a plain whose heights are whole metres, and a slope, are no water.
TEST(Water, PlainsInWholeMetresAreDry) {
    Field<float> plain(200, 200);
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) plain(x, y) = std::floor(float(x) / 4.0f);
    EXPECT_EQ(water_of(plain), Field<std::uint8_t>(200, 200));
    EXPECT_EQ(water_of(rough(72).heights), Field<std::uint8_t>(240, 240));
}

TEST(Water, TouchesSamplesOfOtherGrids) {
    Field<std::uint8_t> mask(30, 30);
    mask(10, 5) = 1;
    const Field<std::uint8_t> coarse = touched(mask, 3.0, 10, 10);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x) EXPECT_EQ(coarse(x, y), x == 3 && y == 1);
    EXPECT_EQ(touched(mask, 1.0, 30, 30), mask);
    // Across two samples both; finer ones within it all.
    EXPECT_TRUE(touched(mask, 2.5, 12, 12)(4, 2));
    const Field<std::uint8_t> fine = touched(mask, 0.5, 60, 60);
    EXPECT_TRUE(fine(20, 10) && fine(21, 11) && !fine(22, 10) && !fine(19, 10));
}

TEST(Water, MasksGrow) {
    Field<std::uint8_t> mask(20, 20);
    mask(10, 5) = 1;
    const Field<std::uint8_t> more = grown(mask, 3);
    int count = 0;
    for (const std::uint8_t set : more) count += set;
    EXPECT_EQ(count, 49);
    EXPECT_TRUE(more(13, 8) && more(7, 2) && !more(14, 5));
}

}  // namespace
}  // namespace cydonia::statistics
