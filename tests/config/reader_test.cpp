#include <cmath>

#include "field/vec.h"
#include "tests/config/scene_file.h"

namespace cydonia::config {
namespace {

using Reader = SceneFile;

template <class Options>
const Options& stage(const SceneSpec& scene, std::size_t i) {
    return std::get<Options>(scene.stages.at(i).options);
}

TEST_F(Reader, LeastSceneHasTheStructsDefaults) {
    const SceneSpec s = load(kLeastScene).at(0);
    const distance::Options plain;
    const auto& d = stage<distance::Options>(s, 0);
    EXPECT_EQ(s.seed, SceneSpec{}.seed);
    EXPECT_EQ(s.terrain.width, TerrainSpec{}.width);
    EXPECT_EQ(s.terrain.samples, TerrainSpec{}.samples);
    EXPECT_EQ(d.grain, plain.grain);
    EXPECT_EQ(d.sea_level_threshold, plain.sea_level_threshold);
    EXPECT_FALSE(d.edge_weights || d.mean_edge_weight_map || d.preview);
    ASSERT_EQ(d.groups.size(), 1u);
    EXPECT_EQ(std::get<distance::Peaks>(d.groups[0].where).placement.count, 3);
    EXPECT_EQ(d.groups[0].name, "group-1");
    EXPECT_EQ(d.groups[0].cost.noise, NoiseOptions{});
    EXPECT_FALSE(d.groups[0].cost.range || d.groups[0].cost.share);
    EXPECT_TRUE(d.groups[0].profile.empty() && d.profiles.empty());
    EXPECT_FALSE(s.render.sun || s.render.water || s.render.colour.config);
    EXPECT_TRUE(s.render.cameras.empty());
    EXPECT_EQ(s.render.ground.rock_slope, render::GroundOptions{}.rock_slope);
}

TEST_F(Reader, FullSceneOfTerrain) {
    const SceneSpec s = load(golden_text("full.toml")).at(0);
    EXPECT_EQ(s.title, "Every key");
    EXPECT_EQ(s.seed, 7u);
    EXPECT_EQ(s.terrain.width, 6000.0);
    EXPECT_EQ(s.terrain.depth, 4000.0);
    ASSERT_EQ(s.stages.size(), 9u);

    const auto& d = stage<distance::Options>(s, 0);
    EXPECT_EQ(d.metric, distance::Options::Metric::kThesis);
    EXPECT_EQ(d.grain, of_width(0.01));
    EXPECT_EQ(d.combine, distance::Options::Combine::kReplace);
    EXPECT_EQ(d.vertical_scale, 0.45);
    EXPECT_TRUE(d.preview);
    const auto& maps = stage<distance::Options>(s, 1);
    EXPECT_EQ(maps.edge_weight_deviation_map->range, (std::array{0.4, 0.0}));
    EXPECT_EQ(maps.blending_bias_map->image.name(), "profile.png");
    EXPECT_EQ(stage<distance::Options>(s, 2).edge_weights->range[0], 0.25);
    EXPECT_EQ(stage<distance::Options>(s, 2).neighbours, 16);

    const auto& p = stage<pareidolia::Options>(s, 3);
    EXPECT_EQ(p.images.at(0).azimuth, std::nullopt);
    EXPECT_EQ(p.images.at(0).elevation, radians(20.0));
    EXPECT_EQ(p.images.at(0).target->name(), "ridges.svg");
    EXPECT_EQ(p.features.secondary_peaks, 5);
    EXPECT_EQ(p.features.holes, pareidolia::Holes::kIterative);
    EXPECT_EQ(p.height_budget, 900.0);
    EXPECT_EQ(p.images[0].reading, pareidolia::Reading::kAlpha);
    EXPECT_EQ(p.images[0].threshold, 0.4);
    EXPECT_TRUE(p.images[0].invert);
    EXPECT_EQ(p.images[0].placing.position, (std::array{0.4, 0.5}));
    EXPECT_EQ(p.images[0].placing.scale, 0.8);
    EXPECT_EQ(p.images[0].placing.rotation, radians(-30.0));

    const auto& m = stage<dem::Options>(s, 4);
    EXPECT_EQ(m.source.name(), "profile.png");
    EXPECT_EQ(m.position, (std::array{0.25, 0.75}));
    EXPECT_TRUE(m.fit);
    EXPECT_EQ(m.vertical_scale, 1.5);

    const auto& by_example = stage<detail::Options>(s, 5);
    ASSERT_EQ(by_example.targets.size(), 3u);
    EXPECT_EQ(by_example.targets[1].source.name(), "profile.png");
    EXPECT_EQ(by_example.targets[1].colour, std::nullopt);
    EXPECT_EQ(by_example.targets[2].colour, (std::array<std::uint8_t, 3>{0, 128, 0}));
    EXPECT_EQ(by_example.targets[1].scale, 0.5);
    EXPECT_EQ(by_example.targets[2].scale, 2.0);
    EXPECT_EQ(by_example.levels, 2);
    EXPECT_EQ(by_example.strength, 1.2);
    EXPECT_EQ(by_example.kind, detail::Kind::kMultifractal);
    EXPECT_EQ(by_example.filter, detail::Filter::kCubic);
    EXPECT_EQ(by_example.search, detail::Search::kExhaustive);
    EXPECT_EQ(by_example.block, 0.1);
    EXPECT_EQ(by_example.candidates, 30);
    EXPECT_EQ(by_example.orientations, 8);
    EXPECT_TRUE(by_example.adapt);
    EXPECT_EQ(by_example.paint->name(), "profile.png");
    ASSERT_EQ(by_example.mappings.size(), 2u);
    EXPECT_EQ(by_example.mappings[0].target, 2);
    EXPECT_EQ(by_example.mappings[0].from, (std::array{0.4, 0.6}));
    EXPECT_EQ(by_example.mappings[0].to, (std::array{0.3, 0.7}));
    EXPECT_EQ(by_example.mappings[0].size, (std::array{0.2, 0.1}));
    ASSERT_EQ(by_example.mappings[1].outline.size(), 3u);
    EXPECT_EQ(by_example.mappings[1].outline[2], (std::array{0.5, 0.8}));

    const auto& sketched = stage<sketch::Options>(s, 6);
    EXPECT_EQ(sketched.levels, 5);
    EXPECT_EQ(sketched.noise, sketch::NoiseKind::kDetail);
    EXPECT_EQ(sketched.noise_from->name(), "profile.png");
    ASSERT_EQ(sketched.features.size(), 2u);
    const sketch::Feature& range = sketched.features[0];
    EXPECT_EQ(range.name, "range");
    ASSERT_EQ(range.way.points.size(), 3u);
    EXPECT_EQ(range.way.points[1][1], of_width(0.4));
    EXPECT_EQ(range.height, 100.0);
    EXPECT_FALSE(range.relative);
    EXPECT_EQ((*range.boundary)[1], metres(200.0));
    ASSERT_EQ(range.holds.size(), 2u);
    EXPECT_EQ(range.holds[0].height, 300.0);
    EXPECT_EQ((*range.holds[0].boundary)[1], of_width(0.02));
    EXPECT_FALSE(range.holds[1].boundary);
    EXPECT_EQ(range.silhouette->id, "ridge");
    EXPECT_EQ(range.silhouette->bottom, -10.0);
    EXPECT_EQ(range.silhouette->top, 900.0);
    EXPECT_TRUE(range.silhouette->mouse);
    const sketch::Feature& skyline = sketched.features[1];
    EXPECT_EQ(skyline.boundary_curve->id, "lips");
    EXPECT_EQ(skyline.view->id, "stroke");
    EXPECT_TRUE(skyline.view->mouse);
    EXPECT_EQ(skyline.view->through, std::vector<std::string>{"range"});
    ASSERT_EQ(sketched.regions.size(), 1u);
    EXPECT_EQ(sketched.regions[0].name, "moor");
    EXPECT_EQ(sketched.regions[0].way.drawing->name(), "ridges.svg");
    EXPECT_EQ(sketched.regions[0].length, metres(700.0));
    EXPECT_EQ(sketched.regions[0].noise.top, 50.0);

    const auto& kinds = stage<genetic::Options>(s, 7);
    EXPECT_EQ(kinds.library.types.size(), 2u);
    ASSERT_EQ(kinds.map.regions.size(), 2u);
    EXPECT_EQ(kinds.map.regions[0].name, "west");
    EXPECT_EQ(kinds.map.regions[1].name, "high hills");
    EXPECT_EQ(kinds.map.regions[1].outlines[0].size(), 4u);
    EXPECT_EQ(kinds.map.window[3], 2.0);
    EXPECT_EQ(kinds.map.smoothness, 0.25);
    EXPECT_EQ(kinds.map.envelope, 300.0);
    EXPECT_EQ(kinds.ratio, 2);
    EXPECT_EQ(kinds.coarsest, 640.0);
    EXPECT_EQ(kinds.optimiser, genetic::Optimiser::kEvolution);
    EXPECT_EQ(kinds.evolution.gene, 12);
    EXPECT_EQ(kinds.evolution.crossed, 4);
    EXPECT_EQ(kinds.points.at(0).height, 900.0);
    EXPECT_EQ(kinds.curves.at(0).name, "brook");
    // The library's file and its samples are part of what land is made of.
    EXPECT_EQ(s.stages[7].sources.size(), 3u);

    const auto& c = stage<pareidolia::Options>(s, 8);
    EXPECT_EQ(c.solver, pareidolia::Solver::kConstrained);
    EXPECT_EQ(c.constrained.faithful, 2.0);
    EXPECT_EQ(c.constrained.natural, 0.5);
    EXPECT_EQ(c.constrained.hidden, 0.0);
    EXPECT_EQ(c.constrained.keep->name(), "profile.png");
    ASSERT_EQ(c.images.size(), 2u);
    EXPECT_EQ(c.images[0].text, "HI & <HELLO>");
    EXPECT_EQ(c.images[0].font, "DejaVu Serif");
    EXPECT_EQ(c.images[0].target, std::nullopt);
    EXPECT_EQ(c.images[0].azimuth, radians(300.0));
    EXPECT_EQ(c.images[0].elevation, std::nullopt);
    EXPECT_EQ(c.images[1].reading, pareidolia::Reading::kPhotograph);
    EXPECT_EQ(c.images[1].elevation, radians(25.0));
}

TEST_F(Reader, FullSceneOfRender) {
    const render::Options r = load(golden_text("full.toml")).at(0).render;
    ASSERT_EQ(r.cameras.size(), 6u);
    EXPECT_EQ(r.cameras[5].kind, render::CameraOptions::Kind::kDrawing);
    EXPECT_EQ(r.cameras[5].drawing->name(), "ridges.svg");
    EXPECT_EQ(r.cameras[0].kind, render::CameraOptions::Kind::kOverhead);
    EXPECT_EQ(r.cameras[0].size, (std::array{1024, 512}));
    EXPECT_EQ(r.cameras[1].distance, of_width(0.9));
    EXPECT_EQ(r.cameras[1].sun->azimuth, radians(120.0));
    EXPECT_EQ(r.cameras[2].eye[1], of_width(0.5));
    EXPECT_EQ(r.cameras[2].eye[2], metres(30.0));
    EXPECT_EQ(r.cameras[2].focal_length, 85.0);
    EXPECT_EQ((*r.cameras[2].focus)[0], metres(120.0));
    EXPECT_EQ(r.cameras[2].exposure, -0.5);
    EXPECT_EQ(r.cameras[3].heading, radians(350.0));
    EXPECT_EQ(r.cameras[3].pitch, radians(-2.0));
    EXPECT_FALSE(r.cameras[3].looks_at_target);
    EXPECT_EQ(r.cameras[4].keys[1].frame, 48.0);
    EXPECT_EQ(r.cameras[4].keys[1].eye[0], of_width(0.9));
    EXPECT_EQ(r.cameras[4].shutter_angle, radians(90.0));
    EXPECT_EQ(r.water->level, metres(12.0));
    EXPECT_EQ(r.ground.rock_slope->at(1), radians(42.0));
    EXPECT_EQ(r.ground.look.name, "alpine");
    EXPECT_EQ(r.colour.view, "ACES");
}

TEST_F(Reader, FullSceneOfFrames) {
    const FramesSpec plain = load(kLeastScene).at(0).frames;
    EXPECT_FALSE(plain.count);
    EXPECT_FALSE(plain.place || plain.date || plain.time_zone);
    const FramesSpec f = load(golden_text("full.toml")).at(0).frames;
    EXPECT_EQ(f.count, 72);
    EXPECT_EQ(f.rate, 30.0);
    EXPECT_EQ(f.pace, FramesSpec::Pace::kEven);
    EXPECT_EQ(f.camera, "low");
    EXPECT_EQ(f.place, (GeographicPosition{radians(47.05), radians(8.3)}));
    EXPECT_EQ(f.date, (Date{2026, 6, 21}));
    EXPECT_EQ(f.time_zone, 2.0);
    const std::string place = "[frames]\nplace = { latitude = 1, longitude = 2 }\n";
    EXPECT_EQ(load(kLeastScene + place + "date = \"2024-02-29\"\n").at(0).frames.date,
              (Date{2024, 2, 29}));
}

TEST_F(Reader, SourcesAreEveryFileOfAStage) {
    const SceneSpec s = load(golden_text("full.toml")).at(0);
    for (const auto& source : s.stages[1].sources)
        EXPECT_EQ(source.name(), "profile.png");
    EXPECT_EQ(s.stages[1].sources.size(), 4u);
    ASSERT_EQ(s.stages[3].sources.size(), 1u);
    EXPECT_EQ(s.stages[3].sources[0].name(), "ridges.svg");
}

TEST_F(Reader, AbsolutePaths) {
    const std::string path = (folder_ / "ridges.svg").string();
    EXPECT_EQ(complaint(kLeastScene + "water = [{ image = '" + path + "' }]\n"), "");
    EXPECT_EQ(complaint(kLeastScene + "water = [{ image = '" + path + "x' }]\n"),
              "scene.toml:4:20: terrain.stage[0].water[0].image: cannot open "
              "'ridges.svgx': No such file or directory");
}

TEST_F(Reader, KeysInterpolate) {
    const Scene scene = load(
        kLeastScene +
        "mean_edge_weight = { keys = [[10, 2.0], [20, 4.0], [40, 3.0]] }\n"
        "grain = { keys = [[0, '1 %'], [10, 200.0]] }\n"
        "[render]\nsun = { azimuth = { keys = [[0, 350.0], [10, 370.0]] }, elevation = 9 "
        "}\n");
    const auto weight = [&](double frame) {
        return stage<distance::Options>(scene.at(frame), 0).mean_edge_weight;
    };
    EXPECT_EQ(weight(-5), 2.0);
    EXPECT_EQ(weight(10), 2.0);
    EXPECT_EQ(weight(15), 3.0);
    EXPECT_EQ(weight(20), 4.0);
    EXPECT_EQ(weight(30), 3.5);
    EXPECT_EQ(weight(1e9), 3.0);
    const SceneSpec half = scene.at(5);
    EXPECT_EQ(stage<distance::Options>(half, 0).grain, (Length{100.0, 0.005}));
    EXPECT_NEAR(half.render.sun->azimuth, radians(360.0), 1e-12);
    EXPECT_THROW(scene.at(std::nan("")), Error);
}

TEST_F(Reader, KeysChangeTheCanonicalTextOfTheirStageOnly) {
    const Scene scene = load(golden_text("full.toml"));
    const SceneSpec a = scene.at(0), b = scene.at(12);
    EXPECT_NE(a.stages[0].text, b.stages[0].text);
    EXPECT_EQ(a.stages[4].text, b.stages[4].text);
    EXPECT_NE(a.render_text, b.render_text);  // the sun moves
}

TEST_F(Reader, CanonicalTextIgnoresOrderAndComments) {
    const SceneSpec a = load(
                            "[[terrain.stage]]\nmethod = 'distance'\n"
                            "minimum_scale = 0.1\ngrain = \"5 %\"\n"
                            "[[terrain.stage.group]]\nprofile = 'own'\n"
                            "strokes.image = 'ridges.svg'\n"
                            "[[terrain.stage.profile]]\nname = 'own'\n"
                            "points = [[0, 1], [1, 0]]\n"
                            "[render]\nsky.fill = 2\nhaze.visibility = 10.0\n")
                            .at(0);
    const SceneSpec b = load(
                            "render.haze = { visibility = 10 } # hazy\n"
                            "render.sky = { fill = 2.0 }\n[[terrain.stage]] # one\n"
                            "grain = '5.0 %'\nprofile = [{ points = [[0, 1.0], "
                            "[0x1, 0]], name = 'own' }]\nminimum_scale = 1e-1\n"
                            "group = [{ strokes = { image = './ridges.svg' }, "
                            "profile = ['own'] }]\nmethod = 'distance'\n")
                            .at(0);
    EXPECT_EQ(a.stages[0].text, b.stages[0].text);
    EXPECT_EQ(a.render_text, b.render_text);
    EXPECT_EQ(a.stages[0].text.find(".svg"), std::string::npos);
    EXPECT_LT(a.stages[0].text.find("\ngrain"), a.stages[0].text.find("\nmethod"));
    EXPECT_LT(a.stages[0].text.find("\nmethod"), a.stages[0].text.find("\nneighbours"));
}

TEST_F(Reader, CanonicalTextKnowsFilesByContent) {
    const auto text = [&](const char* name) {
        return load(kLeastScene + "region = [{ image = '" + name + "' }]\n")
            .at(0)
            .stages[0]
            .text;
    };
    std::filesystem::copy_file(folder_ / "ridges.svg", folder_ / "copy.svg");
    const std::string before = text("ridges.svg");
    EXPECT_EQ(text("copy.svg"), before);
    std::ofstream(folder_ / "copy.svg", std::ios::app) << " ";
    EXPECT_NE(text("copy.svg"), before);
}

TEST_F(Reader, CanonicalTextHasFullPrecision) {
    const auto text = [&](const char* number) {
        return load(kLeastScene + "minimum_scale = " + number + "\n")
            .at(0)
            .stages[0]
            .text;
    };
    EXPECT_NE(text("0.1"), text("0.10000000000000002"));
}

TEST_F(Reader, OverridesReplaceAndAdd) {
    const SceneSpec s =
        load(
            golden_text("full.toml"),
            {"terrain.samples=64", "terrain.stage.0.grain=5.5 %",
             "terrain.stage[0].metric=euclidean", "terrain.stage[3].image[0].min_iou=0.5",
             "terrain.stage[0].edge_weight_deviation=0.25", "render.ground.snow_line=7",
             "render.camera[2].eye[2]=31", "title=a = b"})
            .at(0);
    const auto& d = stage<distance::Options>(s, 0);
    EXPECT_EQ(s.terrain.samples, 64);
    EXPECT_EQ(s.title, "a = b");
    EXPECT_EQ(d.grain, of_width(0.055));
    EXPECT_EQ(d.metric, distance::Options::Metric::kEuclidean);
    EXPECT_EQ(d.edge_weight_deviation, 0.25);
    EXPECT_EQ(stage<pareidolia::Options>(s, 3).images[0].min_iou, 0.5);
    EXPECT_EQ(s.render.cameras[2].eye[2], metres(31.0));
    const SceneSpec added = load(kLeastScene, {"render.water.level=3"}).at(0);
    EXPECT_EQ(added.render.water->level, metres(3.0));
}

TEST_F(Reader, NameIsTheFoldersOrTheFiles) {
    const auto name = [&](const std::string& relative) {
        const auto path = folder_ / relative;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path) << kLeastScene;
        return Scene::load(path).at(0).name;
    };
    EXPECT_EQ(name("text/scene.toml"), "text");
    EXPECT_EQ(name("text/../other/scene.toml"), "other");
    EXPECT_EQ(name("foo.toml"), "foo");
    EXPECT_EQ(name("a b.c/scene.toml"), "a-b-c~c05ac95fa89b8bc7");
    EXPECT_EQ(name("..toml"), "-~ab8a815a3d735ad3");
}

}  // namespace
}  // namespace cydonia::config
