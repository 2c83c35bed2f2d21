#include "synth/pareidolia/image.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

#include "field/vec.h"
#include "synth/pareidolia/light_frame.h"
#include "synth/pareidolia/target.h"
#include "tests/synth/target_files.h"

namespace cydonia::pareidolia {
namespace {

class Image : public TargetFiles {
  protected:
    // A bar 1000 m long from west to east on 5000 x 5000 m, lit from the east.
    ImageOptions bar() const {
        return {.target = svg("bar.svg", 100, 100,
                              "<rect x='40' y='45' width='20' height='10'/>"),
                .azimuth = radians(90.0)};
    }
    static Terrain land(int side, float relief = 0.0f) {
        Terrain terrain;
        terrain.heights = Field<float>(side, side);
        terrain.spacing = 5000.0 / side;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                terrain.heights(x, y) = relief * float(x) / float(side - 1);
        return terrain;
    }
    static Options stage(std::vector<ImageOptions> images) {
        Options options;
        options.solver = Solver::kConstrained;
        options.images = std::move(images);
        return options;
    }
    std::vector<ShadowImage> images(const Options& options, const Terrain& terrain) {
        told_ = {};
        return shadow_images(options, terrain, told_);
    }
    std::string refused(const Options& options) {
        return refusal([&] { images(options, land(200)); });
    }
    Told told_;
};

TEST_F(Image, ElevationIsTheHighestThatTheBudgetAllows) {
    Options options = stage({bar()});
    options.images[0].elevation.reset();
    options.height_budget = 310.0;  // of a shadow 1000 m long: 17.2 degrees
    for (const int side : {100, 256, 700}) {
        const double elevation = degrees(images(options, land(side)).at(0).sun.elevation);
        EXPECT_EQ(elevation, 16.5) << side;
        EXPECT_TRUE(contains(told_.notes, "the sun stands 16.5 degrees high"))
            << told_.notes;
    }
}

TEST_F(Image, ElevationStaysWhereShadowsAreClear) {
    Options options = stage({bar()});
    options.images[0].elevation.reset();
    options.height_budget = 5000.0;
    EXPECT_EQ(images(options, land(200)).at(0).sun.elevation, radians(35.0));
    options.height_budget = 20.0;  // 8 degrees need 140 m
    EXPECT_TRUE(contains(refused(options), "needs 14"));
}

TEST_F(Image, WithoutABudgetTheReliefIsIt) {
    Options options = stage({bar()});
    options.images[0].elevation.reset();
    const double gentle = images(options, land(200, 300.0f)).at(0).sun.elevation;
    const double rough = images(options, land(200, 600.0f)).at(0).sun.elevation;
    EXPECT_LT(gentle, rough);
    EXPECT_NEAR(std::tan(gentle) * 1000.0, 300.0, 20.0);
    EXPECT_NEAR(std::tan(rough) * 1000.0, 600.0, 30.0);
    EXPECT_NEAR(std::tan(images(options, land(200)).at(0).sun.elevation) * 1000.0, 250.0,
                10.0);  // flat: a twentieth of the extent
}

TEST_F(Image, BudgetThatIsTooSmallSaysHowMuchIsNeeded) {
    Options options = stage({bar()});
    options.images[0].elevation = radians(25.0);
    options.height_budget = 300.0;
    const std::string message = refused(options);
    EXPECT_TRUE(contains(message, "bar: its longest shadow")) << message;
    EXPECT_TRUE(contains(message, "needs 47")) << message;  // 1000 m tan(25 degrees)
    EXPECT_TRUE(contains(message, "height_budget is 300 m")) << message;
    // What it advises is accepted.
    const auto at = message.find("lower the sun to ");
    ASSERT_NE(at, std::string::npos) << message;
    options.images[0].elevation = radians(
        std::strtod(message.c_str() + at + std::strlen("lower the sun to "), nullptr));
    EXPECT_EQ(refused(options), "");
    EXPECT_GT(*options.images[0].elevation, radians(16.0));
}

TEST_F(Image, AzimuthIsWhereTheLongestShadowIsShortest) {
    Options options = stage({bar()});
    options.images[0].azimuth.reset();
    const ShadowImage image = images(options, land(200)).at(0);
    EXPECT_EQ(image.sun.azimuth, shortest_azimuth(image.target));
    EXPECT_EQ(image.sun.elevation, radians(25.0));
    EXPECT_TRUE(contains(told_.notes, "bar: the sun stands at azimuth")) << told_.notes;
    EXPECT_EQ(images(options, land(400)).at(0).sun.azimuth, image.sun.azimuth);
}

TEST_F(Image, TooThinForTheSearchStillFindsASun) {
    Options options = stage({{.target = svg("thread.svg", 1000, 1000,
                                            "<rect x='300' y='500' width='400' "
                                            "height='1.2'/>")}});
    options.images[0].elevation.reset();
    const ShadowImage image = images(options, land(1000)).at(0);
    EXPECT_EQ(image.sun.azimuth, 0.0);
    EXPECT_EQ(image.sun.elevation, radians(35.0));
}

TEST_F(Image, TouchingTheSunnyEdgeIsSaid) {
    ImageOptions touching = bar();
    touching.placing.position = {0.9, 0.5};
    images(stage({touching}), land(200));
    EXPECT_TRUE(contains(told_.notes, "20 cells of shadow touch the edge"))
        << told_.notes;
    touching.azimuth = radians(270.0);  // now the edge is behind it
    images(stage({touching}), land(200));
    EXPECT_FALSE(contains(told_.notes, "touch the edge")) << told_.notes;
}

TEST_F(Image, EveryImageHasItsNameAndSun) {
    Options options = stage({bar(), bar(), {.text = "bar"}});
    options.images[1].azimuth = radians(10.0);
    options.images[2].min_iou = 0.5;
    const auto all = images(options, land(200));
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].name, "bar");
    EXPECT_EQ(all[1].name, "bar-2");
    EXPECT_EQ(all[2].name, "bar-3");
    EXPECT_EQ(all[1].sun.azimuth, radians(10.0));
    EXPECT_EQ(all[2].min_iou, 0.5);
}

TEST_F(Image, CountsAndSunsThatCannotBe) {
    EXPECT_TRUE(contains(refused(stage({})), "1 to 4 images, this one has 0"));
    EXPECT_TRUE(contains(refused(stage({bar(), bar(), bar(), bar(), bar()})),
                         "1 to 4 images, this one has 5"));
    Options two = stage({bar(), bar()});
    two.solver = Solver::kFeatures;
    EXPECT_TRUE(contains(refused(two), "exactly one image"));
    Options night = stage({bar()});
    night.images[0].elevation = radians(-3.0);
    EXPECT_TRUE(contains(refused(night), "casts no shadow"));
}

}  // namespace
}  // namespace cydonia::pareidolia
