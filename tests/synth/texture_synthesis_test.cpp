#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <functional>

#include "field/error.h"
#include "field/files.h"
#include "field/image.h"
#include "synth/texture/constraints/constraint_errors.h"
#include "synth/texture/database/database.h"
#include "synth/texture/maker.h"
#include "synth/texture/synthesis/recording.h"
#include "synth/texture/texture.h"
#include "tests/synth/texture_lands.h"

namespace cydonia::texture {
namespace {

namespace fs = std::filesystem;

constexpr double kSpacing = 30.0;

// Land from two small exemplars, their databases made once.
class Syntheses : public testing::Test {
  protected:
    Syntheses() {
        options_.exemplars = {
            exemplar_of(files(), "a.tif", rough(150, 130), kSpacing),
            exemplar_of(files(), "b.tif", rough(120, 140, 2), kSpacing)};
        context_.seed = 7;
        context_.progress = &silent_;
        context_.cache = files() / "cache";
    }
    static const TemporaryFolder& files() {
        static const TemporaryFolder folder;
        return folder;
    }
    Terrain flat(int width, int height, double spacing = kSpacing) const {
        Terrain terrain;
        terrain.heights = {width, height};
        terrain.spacing = spacing;
        return terrain;
    }
    Terrain made(int width = 200, int height = 180, double spacing = kSpacing) const {
        return run(options_, flat(width, height, spacing), context_);
    }
    void ask_for_points_and_curves() {
        options_.points = {{.name = "top",
                            .at = {metres(1500.0), metres(1500.0)},
                            .height = 900.0,
                            .radius = metres(900.0)}};
        options_.curves = {{.name = "ridge",
                            .points = {{metres(3000.0), metres(800.0)},
                                       {metres(4200.0), metres(2500.0)},
                                       {metres(5000.0), metres(4500.0)}},
                            .height = 700.0,
                            .gradient = {-0.3, -0.5},
                            .area = {metres(600.0), metres(900.0)}}};
    }

    Options options_;
    SilentProgress silent_;
    Context context_;
};

Field<float> part_of(const Field<float>& whole, int x, int y, int width, int height) {
    Field<float> part(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) part(i, j) = whole(x + i, y + j);
    return part;
}

template <class Colour>
Source picture_of(const TemporaryFolder& folder, const std::string& name, int width,
                  int height, const Colour& colour_at) {
    Field<Rgb8> picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) picture(x, y) = colour_at(x, y);
    write_png(folder / name, picture);
    return open_source(folder / name);
}

TEST_F(Syntheses, AnyTileAloneEqualsTheWhole) {
    ask_for_points_and_curves();
    const Field<float> whole = made().heights;
    for (const auto& [x, y, w, h] : {std::array{0, 0, 64, 50}, std::array{63, 41, 37, 80},
                                     std::array{150, 120, 50, 60}})
        EXPECT_EQ(tile(options_, {200, 180, kSpacing}, context_, x, y, w, h),
                  part_of(whole, x, y, w, h))
            << x << ' ' << y;
}

TEST_F(Syntheses, TilesBetweenTheExemplarsCellsEqualTheWhole) {
    for (const double spacing : {kSpacing * 1.37, kSpacing * 0.8, kSpacing * 2.5}) {
        const Field<float> whole = made(90, 80, spacing).heights;
        EXPECT_EQ(tile(options_, {90, 80, spacing}, context_, 33, 21, 30, 40),
                  part_of(whole, 33, 21, 30, 40))
            << spacing;
    }
}

TEST_F(Syntheses, TurnedExemplarsTooEqualTheWhole) {
    options_.orientations = 8;
    EXPECT_EQ(tile(options_, {200, 180, kSpacing}, context_, 40, 40, 50, 50),
              part_of(made().heights, 40, 40, 50, 50));
}

TEST_F(Syntheses, OneThreadOrFour) {
    ask_for_points_and_curves();
    Field<float> one, four;
    {
        const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
        one = made().heights;
    }
    const tbb::global_control many(tbb::global_control::max_allowed_parallelism, 4);
    EXPECT_EQ(made().heights, one);
}

TEST_F(Syntheses, AnotherSeedIsOtherLand) {
    const Field<float> first = made().heights;
    context_.seed = 8;
    EXPECT_NE(made().heights, first);
}

// Design: the same land after a low-pass, within 5% of the relief.
TEST_F(Syntheses, HalfTheSamplesAreTheSameLand) {
    constexpr int kMean = 5;  // cells of the coarse terrain
    const auto mean = [](const Field<float>& land, int x, int y, int side) {
        double sum = 0.0;
        for (int v = side * y; v < side * (y + 1); ++v)
            for (int u = side * x; u < side * (x + 1); ++u) sum += land(u, v);
        return sum / (side * side);
    };
    const Field<float> fine = made(200, 180).heights;
    const Field<float> coarse = made(100, 90, 2.0 * kSpacing).heights;
    const auto [low, high] = std::ranges::minmax(fine);
    double error = 0.0;
    for (int y = 0; y < 90 / kMean; ++y)
        for (int x = 0; x < 100 / kMean; ++x)
            error += std::pow(mean(fine, x, y, 2 * kMean) - mean(coarse, x, y, kMean), 2);
    EXPECT_LT(std::sqrt(error / (90 / kMean * (100 / kMean))), 0.05 * (high - low));
}

TEST_F(Syntheses, AWholeExemplarPastedIsThatExemplar) {
    options_.pastes = {{.name = "all",
                        .exemplar = 1,
                        .to = {metres(100 * kSpacing), metres(90 * kSpacing)},
                        .raise = 0.0}};
    const Field<float> land = made().heights;
    const Field<float> exemplar = rough(150, 130);
    EXPECT_EQ(part_of(land, 100 - 75 + 3, 90 - 65 + 3, 144, 124),
              part_of(exemplar, 3, 3, 144, 124));
}

TEST_F(Syntheses, APasteMayBeTurnedRaisedAndRound) {
    options_.pastes = {{.name = "disc",
                        .exemplar = 2,
                        .from = {0.5, 0.5},
                        .to = {metres(60 * kSpacing), metres(70 * kSpacing)},
                        .radius = metres(20 * kSpacing),
                        .raise = 100.0,
                        .turn = 1}};
    const Field<float> land = made().heights;
    const Field<float> exemplar = rough(120, 140, 2);
    // A quarter clockwise: what was west of the middle is north of it.
    for (int d = 1; d < 18; ++d)
        EXPECT_NEAR(land(60, 180 - 70 - d), exemplar(60 - d, 69) + 100.0f, 0.05f) << d;
}

TEST_F(Syntheses, AMirroredPasteHasEastForWest) {
    options_.pastes = {{.name = "disc",
                        .exemplar = 1,
                        .from = {0.5, 0.5},
                        .to = {metres(60 * kSpacing), metres(70 * kSpacing)},
                        .radius = metres(20 * kSpacing),
                        .mirror = true}};
    const Field<float> land = made().heights;
    const Field<float> exemplar = rough(150, 130);
    for (int d = 1; d < 18; ++d) EXPECT_EQ(land(60 + d, 110), exemplar(74 - d, 65)) << d;
}

TEST_F(Syntheses, APasteFromTheTerrainIsThatPartOfIt) {
    const Field<float> before = made().heights;
    options_.pastes = {{.name = "copy",
                        .exemplar = 0,
                        .from = {0.25, 0.5},
                        .to = {metres(140 * kSpacing), metres(90 * kSpacing)},
                        .radius = metres(25 * kSpacing),
                        .raise = -40.0}};
    const Field<float> land = made().heights;
    for (int d = -20; d <= 20; ++d) {
        EXPECT_NEAR(land(140 + d, 90), before(50 + d, 90) - 40.0f, 0.05f) << d;
        EXPECT_NEAR(land(140, 90 + d), before(50, 90 + d) - 40.0f, 0.05f) << d;
    }
}

TEST_F(Syntheses, APasteBesideTheTerrainIsRefused) {
    options_.pastes = {{.name = "lost",
                        .exemplar = 1,
                        .to = {metres(90000.0), metres(100.0)},
                        .radius = metres(300.0)}};
    EXPECT_THROW(made(), Error);
}

TEST_F(Syntheses, APasteLargerThanTheTerrainCoversIt) {
    options_.pastes = {{.name = "all",
                        .exemplar = 1,
                        .to = {metres(20 * kSpacing), metres(20 * kSpacing)}}};
    const Field<float> land = made(40, 40).heights;
    EXPECT_EQ(land, part_of(rough(150, 130), 55, 45, 40, 40));
}

TEST_F(Syntheses, PointsAndCurvesAreMet) {
    ask_for_points_and_curves();
    const Terrain land = made();
    const auto [low, high] = std::ranges::minmax(land.heights);
    EXPECT_LT(land.figures.at("texture: constraint error, RMS, m"), 0.01 * (high - low));
    EXPECT_NEAR(land.heights(50, 180 - 50), 900.0f, 0.02 * (high - low));
}

TEST_F(Syntheses, RelativeHeightsAddToTheLandThatWouldBe) {
    const Field<float> before = made().heights;
    options_.points = {{.name = "up",
                        .at = {metres(3000.0), metres(2700.0)},
                        .height = 120.0,
                        .relative = true,
                        .radius = metres(800.0)}};
    const Field<float> land = made().heights;
    double rise = 0.0;
    for (int y = 88; y <= 92; ++y)
        for (int x = 98; x <= 102; ++x) rise += (land(x, y) - before(x, y)) / 25.0;
    EXPECT_NEAR(rise, 120.0, 60.0);
}

// A scene that is coherent, run after run.
class CoherentRuns : public Syntheses {
  protected:
    CoherentRuns() {
        options_.coherent = true;
        context_.memory = &memory_;
    }
    Field<float> next() {
        const Field<float> land = made().heights;
        fs::rename(memory_.next, memory_.last);
        return land;
    }

    const TemporaryFolder runs_;
    const Memory memory_{runs_ / "last", runs_ / "next"};
};

TEST_F(CoherentRuns, TheSameAgainIsTheSame) {
    ask_for_points_and_curves();
    const Field<float> first = next();
    EXPECT_EQ(next(), first);
}

TEST_F(CoherentRuns, WithoutAPastTheyAreLikeOthers) {
    const Field<float> coherent = next();
    options_.coherent = false;
    EXPECT_EQ(made().heights, coherent);
}

TEST_F(CoherentRuns, WhatIsFrozenStaysWhenAPointMoves) {
    ask_for_points_and_curves();
    const Field<float> first = next();
    options_.frozen = picture_of(runs_, "frozen.png", 200, 180, [](int x, int) {
        return x >= 120 ? Rgb8{255, 255, 255} : Rgb8{0, 0, 0};
    });
    options_.points[0].height = 1300.0;
    const Field<float> second = next();
    EXPECT_NE(second, first);
    EXPECT_EQ(part_of(second, 120, 0, 80, 180), part_of(first, 120, 0, 80, 180));
}

TEST_F(CoherentRuns, FarFromAnEditMostLandStays) {
    options_.points = {{.name = "top",
                        .at = {metres(900.0), metres(900.0)},
                        .height = 900.0,
                        .radius = metres(600.0)}};
    const auto changed = [&](bool coherent) {
        options_.coherent = coherent;
        options_.points[0].height = 600.0;
        const Field<float> first = coherent ? next() : made().heights;
        options_.points[0].height = 900.0;
        const Field<float> second = coherent ? next() : made().heights;
        int cells = 0;
        for (int y = 0; y < 100; ++y)
            for (int x = 100; x < 200; ++x) cells += first(x, y) != second(x, y);
        return cells;
    };
    const int free = changed(false), kept = changed(true);
    EXPECT_LE(kept, free / 4);
}

TEST_F(CoherentRuns, ADamagedPastIsNoPast) {
    const Field<float> first = next();
    std::string bytes = read_text(memory_.last);
    for (const std::size_t at : {std::size_t{3}, bytes.size() / 2, bytes.size() - 1}) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x40);
        write_text(memory_.last, damaged);
        EXPECT_FALSE(load_run(memory_.last)) << at;
    }
    write_text(memory_.last, bytes.substr(0, 1000));
    EXPECT_FALSE(load_run(memory_.last));
    EXPECT_EQ(next(), first);
}

TEST_F(Syntheses, PaintedTypesAreObeyed) {
    options_.types = {{"calm", {0, 0, 255}}, {"rough", {255, 0, 0}}};
    options_.exemplars[0].type = "calm";
    options_.exemplars[1].type = "rough";
    options_.paint = picture_of(files(), "paint.png", 200, 180, [](int x, int) {
        return x < 100 ? Rgb8{0, 0, 255} : Rgb8{255, 0, 0};
    });
    const auto obeyed = [&](const Terrain& land) {
        return land.figures.at("texture: cells of the asked type, share");
    };
    EXPECT_GT(obeyed(made()), 0.97);
    // With so few samples the last level is one that else knows types.
    EXPECT_GT(obeyed(made(200, 180, 4.0 * kSpacing)), 0.9);
}

}  // namespace
}  // namespace cydonia::texture
