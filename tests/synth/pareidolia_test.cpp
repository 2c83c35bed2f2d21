#include "synth/pareidolia/pareidolia.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "field/error.h"
#include "field/image.h"
#include "field/random.h"
#include "render/shadow/caster.h"
#include "render/shadow/check.h"
#include "synth/pareidolia/height_bound.h"
#include "synth/pareidolia/light_frame.h"
#include "synth/pareidolia/shadow_plan.h"

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

// A black rectangle [x0, x1) x [y0, y1) on white.
Field<std::uint8_t> box(int side, int x0, int y0, int x1, int y1) {
    Field<std::uint8_t> image(side, side);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) image(x, y) = 1;
    return image;
}

// The image as a file that a scene could name.
class TargetFile {
  public:
    explicit TargetFile(const Field<std::uint8_t>& dark)
        : path_(std::filesystem::temp_directory_path() /
                ("cydonia_target_" + std::to_string(::getpid()) + ".png")) {
        Field<std::uint8_t> grey(dark.width(), dark.height());
        for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = dark[i] ? 0 : 255;
        write_png(path_, grey);
    }
    ~TargetFile() { std::filesystem::remove(path_); }
    Source source() const { return open_source(path_); }

  private:
    std::filesystem::path path_;
};

Terrain flat(int side) {
    Terrain terrain;
    terrain.heights = Field<float>(side, side);
    terrain.spacing = 5120.0 / side;
    return terrain;
}

Options options_for(const Source& target, double azimuth_degrees) {
    Options options;
    options.images = {{.target = target, .azimuth = radians(azimuth_degrees)}};
    options.features.mean_edge_weight = 1.2;
    options.features.edge_weight_deviation = 0.8;
    return options;
}

Terrain synthesised(const Options& options, int side) {
    SilentProgress progress;
    return run(options, flat(side), {.seed = 7, .cast = {}, .progress = &progress});
}

std::string refusal(const Options& options) {
    try {
        synthesised(options, 64);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::kBadRequest);
        return e.what();
    }
    return "";
}

}  // namespace

TEST(LightFrame, PlacesAndFindsTheSamePoint) {
    const LightFrame frame = light_frame(80, 60, radians(37.0), 3);
    for (double sample : {0.0, 51.5, 200.0}) {
        const GridPoint p = frame.position(sample, 17.0);
        EXPECT_NEAR(frame.sample_at(p), sample, 1e-9);
        EXPECT_NEAR(frame.row_at(p), 17.0, 1e-9);
    }
}

TEST(LightFrame, LightFromTheEastTravelsWest) {
    const LightFrame frame = light_frame(64, 64, radians(90.0), 1);
    EXPECT_NEAR(frame.along.x, -1.0, 1e-12);
    EXPECT_NEAR(frame.along.y, 0.0, 1e-12);
}

TEST(Runs, AreAsLongAsABoxIsWideAndAsManyAsItIsHigh) {
    const auto image = box(64, 20, 10, 44, 40);
    const LightFrame frame = light_frame(64, 64, radians(90.0), 2);
    const auto runs = runs_of(rotated(image, frame));
    EXPECT_EQ(runs.size(), 60u);  // 30 rows, two a cell
    for (const auto& run : runs) EXPECT_EQ(run.past - run.first, 48);
}

TEST(Azimuth, ABarIsLitAcross) {
    EXPECT_NEAR(shortest_azimuth(box(128, 60, 20, 68, 108)), radians(90.0), 1e-9);
    EXPECT_NEAR(shortest_azimuth(box(128, 20, 60, 108, 68)), 0.0, 1e-9);
}

TEST(Crests, StandAsHighAsTheirShadowIsLongTimesTheSun) {
    ShadowImage image{.name = "box",
                      .target = box(64, 20, 10, 44, 40),
                      .sun = {radians(90.0), radians(30.0)}};
    const ShadowPlan plan = shadow_plan(image, 10.0);
    const Field<float> ground(64, 64, 100.0f);
    for (float crest : crest_heights(plan, ground))
        EXPECT_NEAR(crest, 100.0 + 240.0 * std::tan(radians(30.0)),
                    0.01);  // eq. 5.1, 5.4
}

TEST(Crests, StandOnTheSunnySide) {
    ShadowImage image{.name = "box",
                      .target = box(64, 20, 10, 44, 40),
                      .sun = {radians(90.0), radians(30.0)}};
    const ShadowPlan plan = shadow_plan(image, 10.0);
    const auto primary =
        primary_features(plan, std::vector<float>(plan.runs.size(), 1.0f));
    for (int y = 0; y < 64; ++y) {
        int crests = 0;
        for (int x = 0; x < 64; ++x) {
            if (primary(x, y) == kNowhere) continue;
            ++crests;
            EXPECT_TRUE(x >= 43 && x <= 45) << x;  // the box ends at 44, the sun is east
        }
        EXPECT_EQ(crests > 0, y >= 10 && y < 40) << y;
    }
}

TEST(HeightBound, IsTheLineOfLightInsideAShadow) {
    const auto target = box(64, 20, 10, 44, 40);
    const Field<float> base(64, 64, 50.0f);
    const auto band = anti_shadow(target, 4.0);
    const auto bound = height_bound(base, target, band, radians(90.0), 5.0, 400.0);
    for (int x = 20; x < 44; ++x)  // Algorithm 5: the shadow ends at x = 20
        EXPECT_NEAR(bound(x, 25), 50.0 + 5.0 * (x - 20 + 1), 5.1);
    EXPECT_GT(bound(30, 25), bound(22, 25));
}

TEST(HeightBound, FreeGroundMayBeAsHighAsThePrimaryFeatures) {
    const auto target = box(64, 20, 10, 44, 40);
    const Field<float> base(64, 64, 50.0f);
    const auto bound =
        height_bound(base, target, anti_shadow(target, 4.0), radians(90.0), 5.0, 400.0);
    EXPECT_FLOAT_EQ(bound(30, 60), 400.0f);  // no shadow on this line of light
    for (float b : bound) EXPECT_LE(b, 400.0f);
}

TEST(AntiShadow, SurroundsTheShadowAndLeavesItOut) {
    const auto target = box(64, 20, 20, 40, 40);
    const auto band = anti_shadow(target, 3.0);
    EXPECT_EQ(band(30, 30), 0);
    EXPECT_EQ(band(41, 30), 1);
    EXPECT_EQ(band(42, 30), 1);
    EXPECT_EQ(band(44, 30), 0);
}

TEST(Features, ABoxIsCast) {
    const TargetFile file(box(128, 40, 30, 84, 98));
    for (double azimuth : {60.0, 90.0, 200.0}) {
        const Terrain terrain = synthesised(options_for(file.source(), azimuth), 128);
        const ShadowImage& image = terrain.shadows.at(0);
        const render::Caster caster(terrain.heights, terrain.spacing);
        const auto score = render::score(caster.shadow(image.sun, 2), image.target);
        EXPECT_GT(score.iou, 0.85) << azimuth;
        EXPECT_GT(score.recall, 0.95) << azimuth;
    }
}

TEST(Features, StayOnTheBaseFarFromTheImageWithoutSecondaryOnes) {
    const TargetFile file(box(128, 60, 60, 66, 66));
    Options options = options_for(file.source(), 90.0);
    options.features.secondary_peaks = 0;
    const Terrain terrain = synthesised(options, 128);
    EXPECT_EQ(terrain.heights(5, 5), 0.0f);
    EXPECT_EQ(terrain.heights(120, 120), 0.0f);
}

TEST(Features, OneAndFourThreadsGiveTheSameBytes) {
    const TargetFile file(box(96, 30, 30, 60, 70));
    Options options = options_for(file.source(), 55.0);
    Field<float> heights[2];
    for (int i = 0; i < 2; ++i) {
        tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    i == 0 ? 1 : 4);
        heights[i] = synthesised(options, 96).heights;
    }
    EXPECT_EQ(heights[0], heights[1]);
}

TEST(BadOptions, AreRefused) {
    const TargetFile file(box(32, 10, 10, 20, 20));
    Options rough = options_for(file.source(), 90.0);
    rough.features.edge_weight_deviation = rough.features.mean_edge_weight;
    EXPECT_NE(refusal(rough).find("edge_weight_deviation"), std::string::npos);

    Options night = options_for(file.source(), 90.0);
    night.images[0].elevation = radians(-3.0);
    EXPECT_NE(refusal(night).find("casts no shadow"), std::string::npos);

    Options none = options_for(file.source(), 90.0);
    none.images.clear();
    EXPECT_NE(refusal(none).find("exactly one image"), std::string::npos);
}

TEST(Target, TouchingTheFrameIsCastFromItsEdge) {
    const TargetFile file(box(96, 60, 30, 96, 70));  // its sunny side is the edge
    const Terrain terrain = synthesised(options_for(file.source(), 90.0), 96);
    for (float h : terrain.heights) ASSERT_TRUE(std::isfinite(h));
}
