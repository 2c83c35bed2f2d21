#include "synth/dem/dem.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "field/dem.h"
#include "field/error.h"

namespace cydonia::dem {
namespace {

namespace fs = std::filesystem;

float plane_at(double x, double y) { return static_cast<float>(1000.0 + 2.0 * x - y); }

Context context_of(Progress& progress) {
    Context context;
    context.progress = &progress;
    return context;
}

// plane_at of every cell's centre, in metres from the south-west corner.
Terrain tilted(int width, int height, double spacing) {
    Terrain terrain;
    terrain.spacing = spacing;
    terrain.heights = Field<float>(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            terrain.heights(x, y) =
                plane_at((x + 0.5) * spacing, (height - y - 0.5) * spacing);
    return terrain;
}

class Dem : public testing::Test {
  protected:
    Dem() { fs::create_directories(folder_); }
    ~Dem() override { fs::remove_all(folder_); }

    Options model(const Terrain& terrain) const {
        const fs::path file = folder_ / "model.tif";
        write_geotiff(file, terrain);
        return {.source = open_source(file)};
    }
    static Terrain made(const Options& options, int width, int height, double spacing) {
        SilentProgress silent;
        const Terrain flat{Field<float>(width, height), spacing, {}, {}, {}};
        return run(options, flat, context_of(silent));
    }
    static std::string complaint(const Options& options, int width, int height,
                                 double spacing) {
        try {
            made(options, width, height, spacing);
            return "";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::kBadRequest);
            return error.what();
        }
    }

    const fs::path folder_ =
        fs::temp_directory_path() / ("cydonia_dem_" + std::to_string(getpid()));
};

TEST_F(Dem, SameCellsAreKeptToTheBit) {
    Terrain rough = tilted(9, 6, 30.0);
    for (std::size_t i = 0; i < rough.heights.size(); ++i)
        rough.heights[i] += float(i * 7919 % 101);
    const Terrain land = made(model(rough), 9, 6, 30.0);
    EXPECT_EQ(land.heights, rough.heights);
    EXPECT_EQ(land.spacing, 30.0);
}

// Whatever the sampling, a slope is that slope, in its place.
TEST_F(Dem, SlopesKeepTheirPlace) {
    const Options options = model(tilted(100, 80, 10.0));
    for (const int samples : {7, 40, 90, 200}) {
        const double spacing = 400.0 / samples;
        const Terrain land = made(options, samples, samples, spacing);
        // The window's corner: 300, 200 metres into the model.
        for (int y = 0; y < samples; ++y)
            for (int x = 0; x < samples; ++x)
                ASSERT_NEAR(land.heights(x, y),
                            plane_at(300.0 + (x + 0.5) * spacing,
                                     200.0 + (samples - y - 0.5) * spacing),
                            1e-3 * std::max(10.0, spacing))
                    << samples << ": " << x << ", " << y;
    }
}

TEST_F(Dem, PositionIsCountedFromTheSouthWest) {
    Options options = model(tilted(100, 80, 10.0));
    options.position = {0.2, 0.75};
    const Terrain land = made(options, 20, 20, 10.0);
    EXPECT_NEAR(land.heights(0, 19), plane_at(100.0 + 5.0, 500.0 + 5.0), 1e-2);
}

TEST_F(Dem, FineReliefIsAveragedNotSkipped) {
    Terrain checks = tilted(64, 64, 1.0);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) checks.heights(x, y) = (x + y) % 2 ? 0.0f : 100.0f;
    const Terrain land = made(model(checks), 16, 16, 4.0);
    for (const float height : land.heights) EXPECT_NEAR(height, 50.0f, 2.0f);
}

TEST_F(Dem, FitTakesTheLargestWindow) {
    Options options = model(tilted(100, 80, 10.0));
    options.fit = true;
    const Terrain land = made(options, 40, 40, 1000.0);  // 800 m stand for 40 km
    EXPECT_EQ(land.spacing, 1000.0);
    EXPECT_NEAR(land.heights(0, 39), plane_at(100.0 + 10.0, 10.0), 0.1);
    options.position = {0.0, 0.0};  // moved as far as there is land
    EXPECT_NEAR(made(options, 40, 40, 1000.0).heights(0, 39), plane_at(10.0, 10.0), 0.1);
}

TEST_F(Dem, VerticalScale) {
    Options options = model(tilted(20, 20, 10.0));
    const Terrain plain = made(options, 20, 20, 10.0);
    options.vertical_scale = 2.5;
    EXPECT_FLOAT_EQ(made(options, 20, 20, 10.0).heights(3, 4),
                    2.5f * plain.heights(3, 4));
}

TEST_F(Dem, LandSoFarIsReplaced) {
    SilentProgress silent;
    Terrain before{Field<float>(20, 20, 5e4f), 10.0, {}, {}, {}};
    before.masks["old"] = Field<float>(20, 20);
    const Terrain land = run(model(tilted(20, 20, 10.0)), before, context_of(silent));
    EXPECT_LT(land.heights(0, 0), 2000.0f);
    EXPECT_TRUE(land.masks.empty());
}

TEST_F(Dem, WindowBeyondTheModelNamesBothSizes) {
    Options options = model(tilted(100, 80, 10.0));
    EXPECT_EQ(complaint(options, 90, 90, 10.0),
              "model.tif: the terrain is 900 x 900 m and the model 1000 x 800 m: make "
              "terrain.extent smaller, or set fit = true to stretch the model");
    options.position = {0.1, 0.5};
    EXPECT_EQ(complaint(options, 40, 40, 10.0),
              "model.tif: the terrain is 400 x 400 m and the model 1000 x 800 m, so the "
              "window at position [0.1, 0.5] leaves it: keep position between [0.2, "
              "0.25] and [0.8, 0.75], or set fit = true");
    EXPECT_EQ(complaint(options, 20, 20, 10.0), "");
}

TEST_F(Dem, DamagedModel) {
    Options options = model(tilted(50, 50, 10.0));
    fs::resize_file(options.source.path, 300);
    EXPECT_NE(complaint(options, 20, 20, 10.0).find("model.tif: "), std::string::npos);
}

}  // namespace
}  // namespace cydonia::dem
