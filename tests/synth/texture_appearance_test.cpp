#include "synth/texture/database/appearance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "synth/texture/database/neighbourhood.h"
#include "tests/synth/texture_lands.h"

namespace cydonia::texture {
namespace {

LevelArrays bare_level(const Field<float>& heights) {
    return std::move(pyramid_of({land_of(heights)}, 1).front());
}

LevelArrays seen(const Field<float>& heights, const Modes& modes) {
    LevelArrays level = bare_level(heights);
    add_appearance(level, modes, kScale);
    return level;
}

Modes rough_modes() { return modes_of(bare_level(rough(80, 60))); }

Appearance at(const LevelArrays& level, int x, int y) {
    return level.appearance[level.sheets[0].index(x, y)];
}

TEST(AppearanceSpace, PlaneHasItsHeightAndSlopesOnly) {
    const LevelArrays level =
        seen(heights_of(30, 30, [](int x, int y) { return 3.0 * x - 5.0 * y; }),
             rough_modes());
    const Appearance a = at(level, 10, 12);
    EXPECT_EQ(a[0], (30 - 60) / 0.05);
    EXPECT_GT(a[1], 0);
    EXPECT_NEAR(a[2], -5.0 / 3.0 * a[1], 2.0);
    EXPECT_EQ(a[3], 0);
    EXPECT_EQ(at(level, 20, 20)[1], a[1]);
}

TEST(AppearanceSpace, LevelLiesInTheFirstModeOnly) {
    const Modes modes = rough_modes();
    Field<float> heights = rough(40, 40);
    for (float& height : heights) height = std::round(height);
    const LevelArrays level = seen(heights, modes);
    for (float& height : heights) height += 200.0f;
    const LevelArrays raised = seen(heights, modes);
    for (std::size_t i = 0; i < level.appearance.size(); ++i) {
        Appearance a = level.appearance[i];
        a[0] = static_cast<std::int16_t>(a[0] + 4000);
        ASSERT_EQ(raised.appearance[i], a);
    }
}

TEST(AppearanceSpace, TurnedLandHasTheTurnedModesToTheBit) {
    const Modes modes = rough_modes();
    const Field<float> land = rough(50, 40, 7);
    const LevelArrays level = seen(land, modes);
    for (int o = 0; o < 8; ++o) {
        const Field<float> laid = turned_land(land, o);
        const LevelArrays there = seen(laid, modes);
        for (int y = 0; y < laid.height(); ++y)
            for (int x = 0; x < laid.width(); ++x) {
                const Step halves =
                    turned(o, {2 * x + 1 - laid.width(), 2 * y + 1 - laid.height()});
                const Appearance a = at(level, (halves.x + 49) / 2, (halves.y + 39) / 2);
                ASSERT_EQ(at(there, x, y), turned_appearance(a, o, modes.last_sign))
                    << "orientation " << o << " at " << x << ' ' << y;
            }
    }
}

TEST(AppearanceSpace, TurnedLandHasTheSameModes) {
    const Field<float> land = rough(60, 60);
    const Modes modes = modes_of(bare_level(land));
    for (int o = 1; o < 8; ++o) {
        const Modes other = modes_of(bare_level(turned_land(land, o)));
        EXPECT_EQ(other.last_sign, modes.last_sign);
        for (std::size_t m = 0; m < 4; ++m)
            for (std::size_t i = 0; i < 25; ++i)
                ASSERT_NEAR(other.weights[m][i], modes.weights[m][i], 1) << o;
    }
}

TEST(AppearanceSpace, SignsAreThoseOfTheLastMode) {
    // A saddle of ridges along x and y: the last mode must be one that a quarter turn
    // changes.
    const auto saddles = [](int x, int y) {
        return 100.0 * (std::cos(0.7 * x) - std::cos(0.7 * y));
    };
    const Modes modes = modes_of(bare_level(heights_of(64, 64, saddles)));
    EXPECT_EQ(modes.last_sign, (std::array<std::int8_t, 8>{1, -1, 1, -1, 1, -1, 1, -1}));
    const auto peaks = [](int x, int y) { return x % 8 + y % 8 == 0 ? 100.0 : 0.0; };
    EXPECT_EQ(modes_of(bare_level(heights_of(64, 64, peaks))).last_sign,
              (std::array<std::int8_t, 8>{1, 1, 1, 1, 1, 1, 1, 1}));
}

// Modes are a part of the neighbourhood (Bessel): they never tell of more difference than
// there is, and of most of it.
TEST(AppearanceSpace, DistancesAreThoseOfNeighbourhoods) {
    const Field<float> land = rough(100, 100);
    const Modes modes = modes_of(bare_level(land));
    const LevelArrays level = seen(land, modes);
    double in_modes = 0.0, in_land = 0.0;
    for (int i = 0; i < 500; ++i) {
        const int x = 3 + 7 * i % 91, y = 3 + 13 * i % 89, u = 3 + 31 * i % 83,
                  v = 3 + 17 * i % 79;
        double squares = 0.0;
        for (int k = 0; k < 25; ++k) {
            const double difference =
                land(x + k % 5 - 2, y + k / 5 - 2) - land(u + k % 5 - 2, v + k / 5 - 2);
            squares += modes.weights[0][std::size_t(k)] / double(Modes::kOne) *
                       difference * difference / (kScale.unit * kScale.unit);
        }
        double modes_squares = 0.0;
        for (std::size_t m = 0; m < 4; ++m)
            modes_squares += std::pow(at(level, x, y)[m] - at(level, u, v)[m], 2);
        EXPECT_LE(std::sqrt(modes_squares), std::sqrt(squares) * 1.001 + 2.0);
        // Without heights, which are in both.
        const double mean = std::pow(at(level, x, y)[0] - at(level, u, v)[0], 2);
        in_modes += modes_squares - mean;
        in_land += squares - mean;
    }
    EXPECT_GT(in_modes, 0.85 * in_land);
}

TEST(AppearanceSpace, FlatLandHasModesToo) {
    LevelArrays level = bare_level(Field<float>(20, 20, 4.0f));
    add_appearance(level, modes_of(level), kScale);
    EXPECT_EQ(at(level, 10, 10), (Appearance{80, 0, 0, 0}));
}

TEST(AppearanceSpace, RangeOfHeightsFits) {
    // Steps of the whole range, where modes are largest.
    const LevelArrays level =
        seen(heights_of(40, 40,
                        [](int x, int y) { return (x / 3 + y / 4) % 2 ? 1500 : -1500; }),
             rough_modes());
    for (const Appearance& a : level.appearance)
        for (std::int16_t mode : a) ASSERT_LE(std::abs(mode), 30000);
    const auto highest = heights_of(20, 20, [](int, int) { return 1500; });
    EXPECT_EQ(at(seen(highest, rough_modes()), 9, 9)[0], 30000);
}

}  // namespace
}  // namespace cydonia::texture
