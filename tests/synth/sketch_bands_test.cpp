#include "synth/sketch/bands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "field/random.h"

namespace cydonia::sketch {
namespace {

double mean_square(const Field<float>& field) {
    double sum = 0.0;
    for (const float v : field) sum += double(v) * v;
    return sum / double(field.size());
}

Field<float> waves(int width, int height, double period) {
    Field<float> field(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            field(x, y) = float(std::sin(2.0 * M_PI * x / period) +
                                std::cos(2.0 * M_PI * y / period));
    return field;
}

TEST(Bands, LevelLandStaysLevel) {
    for (const auto& [width, height] : {std::pair{64, 64}, {37, 21}, {50, 1}, {1, 1}}) {
        const Field<float> level(width, height, 250.0f);
        for (const Field<float>& smooth : smoothed(level, 5))
            for (const float h : smooth) ASSERT_NEAR(h, 250.0, 1e-3);
    }
}

// All scales together are the field, whatever its size.
TEST(Bands, LastLevelIsTheFieldAndAllAreAsLarge) {
    Field<float> field(75, 49);
    for (std::size_t i = 0; i < field.size(); ++i)
        field[i] = float(signed_unit(hash_of({i})));
    const auto levels = smoothed(field, 6);
    ASSERT_EQ(levels.size(), 7u);
    for (const Field<float>& level : levels) EXPECT_TRUE(level.same_shape(field));
    EXPECT_TRUE(std::ranges::equal(levels.back(), field));
}

// A wave of 32 samples is wider than 8 and narrower than 64: it is in I_3 of 6 and not in
// I_0.
TEST(Bands, WavesAreInTheScalesWiderThanTheirs) {
    const Field<float> wave = waves(256, 256, 32.0);
    const auto levels = smoothed(wave, 6);
    const double whole = mean_square(wave);
    EXPECT_LT(mean_square(levels[0]), 0.01 * whole);
    Field<float> rest = levels[3];
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= wave[i];
    EXPECT_LT(mean_square(rest), 0.01 * whole);
}

TEST(Bands, LinesAreAsRowsOfAField) {
    Field<float> line(100, 1), field(100, 40);
    for (int x = 0; x < 100; ++x) {
        line(x, 0) = float(signed_unit(hash_of({std::uint64_t(x)})));
        for (int y = 0; y < 40; ++y) field(x, y) = line(x, 0);
    }
    const auto of_line = smoothed(line, 4), of_field = smoothed(field, 4);
    for (int i = 0; i <= 4; ++i)
        for (int x = 0; x < 100; ++x)
            ASSERT_NEAR(of_line[std::size_t(i)](x, 0), of_field[std::size_t(i)](x, 20),
                        1e-5);
}

TEST(Bands, NoiseHasAMeanSquareOfOneInEveryBand) {
    for (int band = 1; band <= 6; ++band)
        EXPECT_NEAR(mean_square(wavelet_noise(0, 0, 1024, 1024, band, 6, 3)), 1.0,
                    band < 3 ? 0.1 : 0.04)
            << band;
}

// Nothing of a band is left where what is narrower is smoothed away.
TEST(Bands, NoiseIsInItsBand) {
    for (int band = 2; band <= 5; ++band) {
        const auto scales = smoothed(wavelet_noise(0, 0, 512, 512, band, 6, 4), 6);
        EXPECT_LT(mean_square(scales[std::size_t(band - 2)]), 0.02) << band;
        Field<float> rest = scales[std::size_t(band)];
        for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= scales.back()[i];
        EXPECT_LT(mean_square(rest), 0.02) << band;
    }
}

TEST(Bands, NoiseIsAPlaneSeenThroughAWindow) {
    const Field<float> whole = wavelet_noise(-64, 0, 320, 256, 3, 6, 5);
    const Field<float> part = wavelet_noise(64, 128, 70, 33, 3, 6, 5);
    for (int y = 0; y < 33; ++y)
        for (int x = 0; x < 70; ++x) ASSERT_EQ(part(x, y), whole(x + 128, y + 128));
    EXPECT_FALSE(std::ranges::equal(part, wavelet_noise(64, 128, 70, 33, 3, 6, 6)));
}

}  // namespace
}  // namespace cydonia::sketch
