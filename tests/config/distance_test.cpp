#include <algorithm>

#include "tests/config/scene_file.h"

namespace cydonia::config {
namespace {

using namespace distance;
using Kind = CostRule::Kind;

class DistanceStage : public SceneFile {
  protected:
    Options full() { return stage(golden_text("full.toml")); }
    Options stage(const std::string& text,
                  const std::vector<std::string>& overrides = {}) {
        const SceneSpec scene = load(text, overrides).at(0);
        return std::get<Options>(scene.stages.at(0).options);
    }
    // Of one group, whose other keys these are.
    Group group(const std::string& keys) {
        return stage("[[terrain.stage]]\nmethod = 'distance'\n[[terrain.stage.group]]\n" +
                     keys)
            .groups.at(0);
    }
};

TEST_F(DistanceStage, GroupsInTheirOrder) {
    const Options o = full();
    std::vector<std::string> names;
    for (const Group& group : o.groups) names.push_back(group.name);
    EXPECT_EQ(names, (std::vector<std::string>{"ranges", "peaks", "group-3", "group-4",
                                               "group-5", "lip"}));
    const auto& strokes = std::get<Strokes>(o.groups[0].where);
    EXPECT_EQ(strokes.image.path, folder_ / "ridges.svg");
    EXPECT_EQ(strokes.colour, (std::array<std::uint8_t, 3>{0xd0, 0x20, 0x20}));
    EXPECT_EQ(o.groups[0].profile, (std::vector<std::string>{"cone", "drawn"}));
    EXPECT_EQ(o.groups[0].other_side, "dome");
    const auto& peaks = std::get<Peaks>(o.groups[1].where).placement;
    EXPECT_EQ(peaks.count, 25);
    EXPECT_EQ(peaks.keep_out->name(), "ridges.svg");
    EXPECT_EQ(peaks.away.at(0).from, "ranges");
    EXPECT_EQ(peaks.away.at(0).distance, of_width(0.05));
    EXPECT_EQ(o.groups[1].profile, std::vector<std::string>{"table"});
    EXPECT_EQ(o.groups[1].ridges.reach, metres(800.0));
    EXPECT_EQ(o.groups[1].ridges.from, (std::vector<std::string>{"ranges", "peaks"}));
    const auto& circles = std::get<Circles>(o.groups[2].where);
    EXPECT_EQ(circles.placement.density, 0.5);
    EXPECT_EQ(circles.radius[1], metres(300.0));
    EXPECT_EQ(std::get<Edges>(o.groups[3].where).threshold, 0.4);
    EXPECT_EQ(std::get<Terraces>(o.groups[4].where).levels.at(1).cost, metres(40.0));
    EXPECT_EQ(std::get<Lip>(o.groups[5].where).distance, of_width(0.02));
}

TEST_F(DistanceStage, CostRules) {
    const Options o = full();
    const CostRule& random = o.groups[0].cost;
    EXPECT_EQ(random.kind, Kind::kRandom);
    EXPECT_EQ(random.range->at(0), metres(300.0));
    const CostRule& noise = o.groups[1].cost;
    EXPECT_EQ(noise.noise.kind, NoiseOptions::Kind::kRidged);
    EXPECT_EQ(noise.share, (std::array{0.2, 0.8}));
    EXPECT_EQ(noise.share_of, "ranges");
    EXPECT_EQ(noise.less, metres(20.0));
    const CostRule& sum = o.groups[2].cost;
    ASSERT_EQ(sum.of.size(), 3u);
    EXPECT_TRUE(sum.inverted);
    EXPECT_NEAR(sum.of[0].azimuth, 0.7853981633974483, 1e-15);
    EXPECT_EQ(sum.of[1].of.at(0).range->at(0), metres(-50.0));
    EXPECT_EQ(sum.of[1].of.at(0).centre[0], of_width(0.2));
    EXPECT_EQ(sum.of[1].of.at(1).kind, Kind::kTerrain);
    EXPECT_EQ(sum.of[2].image->name(), "profile.png");
    const CostRule& drawn = o.groups[3].cost;
    EXPECT_FALSE(drawn.image);
    EXPECT_EQ(drawn.curve.points.at(2)[1], 0.5);
}

TEST_F(DistanceStage, PictureOfADrawnCostIsItsCurve) {
    const CostRule drawn = group(
                               "strokes.image = 'ridges.svg'\n"
                               "cost = { kind = 'drawn', image = 'profile.png' }\n")
                               .cost;
    EXPECT_EQ(drawn.curve.image->name(), "profile.png");
    EXPECT_FALSE(drawn.image);
}

TEST_F(DistanceStage, RegionsAndWater) {
    const Options o = full();
    ASSERT_EQ(o.regions.size(), 2u);
    EXPECT_EQ(o.regions[0].inside, "ranges");
    EXPECT_EQ(o.regions[0].profile, "bowl");
    EXPECT_EQ(o.regions[0].only, (std::vector<std::string>{"ranges", "lip"}));
    EXPECT_EQ(o.regions[1].image->name(), "ridges.svg");
    ASSERT_EQ(o.water.size(), 1u);
    EXPECT_FALSE(o.water[0].level);
    EXPECT_EQ(o.water[0].bed, "drawn");

    const Options plain = stage(kLeastScene + "water = [{ image = 'ridges.svg' }]\n");
    EXPECT_EQ(plain.water.at(0).level, Length{});
    EXPECT_EQ(plain.water.at(0).bed, "bowl");
    EXPECT_EQ(plain.profiles.at(0).name, "bowl");
}

TEST_F(DistanceStage, ShippedProfilesFollowTheStagesOwn) {
    const SceneSpec scene = load(golden_text("full.toml")).at(0);
    const auto& o = std::get<Options>(scene.stages[0].options);
    std::vector<std::string> names;
    for (const Profile& profile : o.profiles) names.push_back(profile.name);
    EXPECT_EQ(names, (std::vector<std::string>{"drawn", "table", "long-cone", "cone",
                                               "dome", "bowl"}));
    EXPECT_EQ(o.profiles[0].curve.points.at(1)[1], 0.5);
    EXPECT_EQ(o.profiles[0].strata.layers, 5);
    EXPECT_EQ(o.profiles[1].curve.table->name(), "profile.csv");
    EXPECT_EQ(o.profiles[2].curve.table->name(), "cone.csv");  // like = "cone"
    EXPECT_EQ(o.profiles[2].reach, of_width(0.4));
    EXPECT_EQ(o.profiles[3].curve.table->name(), "cone.csv");
    EXPECT_FALSE(o.profiles[3].reach);
    EXPECT_GT(std::ranges::count(scene.stages[0].sources, "bowl.csv", &Source::name), 0);
    EXPECT_NE(scene.stages[0].text.find("profile.cone.table = xxh3"), std::string::npos);
}

TEST_F(DistanceStage, OwnProfileComesBeforeAShippedOne) {
    const Options o = stage(kLeastScene +
                            "profile = [{ name = 'cone', points = [[0, 1], [1, 0]] }]\n"
                            "region = [{ image = 'ridges.svg', profile = 'cone' }]\n");
    ASSERT_EQ(o.profiles.size(), 1u);
    EXPECT_EQ(o.profiles[0].curve.points.size(), 2u);
}

TEST_F(DistanceStage, UnusedShippedProfilesStayOut) {
    EXPECT_TRUE(stage(kLeastScene).profiles.empty());
    EXPECT_EQ(group("peaks.count = 3\nprofile = 'cone'\n").profile.size(), 1u);
}

TEST_F(DistanceStage, ColoursByWordAndByNumber) {
    const auto colour = [&](const std::string& name) {
        return *std::get<Strokes>(
                    group("strokes = { image = 'ridges.svg', colour = '" + name + "' }\n")
                        .where)
                    .colour;
    };
    EXPECT_EQ(colour("red"), colour("#FF0000"));
    EXPECT_EQ(colour("green"), colour("#008000"));
    EXPECT_EQ(colour("black"), (std::array<std::uint8_t, 3>{}));
    EXPECT_EQ(colour("#0102fe"), (std::array<std::uint8_t, 3>{1, 2, 254}));
}

TEST_F(DistanceStage, CostsVaryInTime) {
    const Scene scene = load(
        "[[terrain.stage]]\nmethod = 'distance'\n[[terrain.stage.group]]\n"
        "peaks.density = { keys = [[0, 1.0], [10, 2.0]] }\n"
        "cost.share = [0.0, { keys = [[0, 1.0], [10, 0.5]] }]\n");
    const SceneSpec half = scene.at(5);
    const Group& group = std::get<Options>(half.stages[0].options).groups.at(0);
    EXPECT_EQ(std::get<Peaks>(group.where).placement.density, 1.5);
    EXPECT_EQ(group.cost.share->at(1), 0.75);
}

TEST_F(DistanceStage, TooManyGroups) {
    std::string scene = "[[terrain.stage]]\nmethod = 'distance'\n";
    for (int i = 0; i < 65; ++i) scene += "[[terrain.stage.group]]\npeaks.count = 1\n";
    EXPECT_NE(complaint(scene).find(
                  "terrain.stage[0].group: expected an array of 0 to 64, found an array "
                  "of 65"),
              std::string::npos);
}

}  // namespace
}  // namespace cydonia::config
