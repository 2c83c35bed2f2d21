#include "synth/distance/explain.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "synth/distance/blend.h"
#include "synth/distance/distance.h"

namespace cydonia::distance {
namespace {

// The pictures and tables that were shown.
struct Shown {
    std::map<std::string, Field<Rgb8>> pictures;
    std::map<std::string, std::string> tables;
    Explain sinks{
        [this](const std::string& name, const Field<Rgb8>& p) { pictures[name] = p; },
        [this](const std::string& name, const std::string& csv) { tables[name] = csv; }};

    int searches() const {
        return static_cast<int>(std::ranges::count_if(
            pictures, [](const auto& p) { return p.first.starts_with("search-"); }));
    }
};

// Smooth land of 100 x 80 samples, 10 m apart, one feature a start, sea level at 300 m.
struct Land {
    Graph graph = graph_of(100, 80, 10.0, {.mean = 1.0, .deviation = 0.0}, 1);
    Options options;
    Features features;
    Shapes shapes;
    Regions regions;
    Halting halting{.sea_level_threshold = 5.0f, .approximate_threshold = 0.05f};
    PassCounts counts;
    Shown shown;

    explicit Land(const std::vector<Start>& starts) {
        shapes.sea_level = 300.0;
        options.groups.resize(1);
        options.groups[0].name = "peaks";
        for (const Start& start : starts) {
            features.starts.push_back(start);
            features.first.push_back(static_cast<int>(features.starts.size()));
            features.features.push_back({});
        }
    }
    void explain() {
        const Ground ground{graph, features, shapes, regions};
        const auto approximate = approximate_heights(ground, halting);
        Explainer explainer(shown.sinks, options, ground, halting, approximate);
        SilentProgress silent;
        blended_heights(ground, halting, {}, approximate, silent, {nullptr, &explainer},
                        &counts);
        explainer.finish();
    }
    const Field<Rgb8>& picture(const std::string& name) const {
        return shown.pictures.at(name);
    }
};

int count(const Field<Rgb8>& picture, const Rgb8& colour) {
    return static_cast<int>(std::ranges::count(picture, colour));
}

// Cells of a line of features.csv, by column name.
std::vector<std::map<std::string, std::string>> lines_of(const std::string& csv) {
    const auto cells = [](const std::string& line) {
        std::vector<std::string> result;
        std::istringstream text(line);
        for (std::string cell; std::getline(text, cell, ',');) result.push_back(cell);
        return result;
    };
    std::istringstream text(csv);
    std::string line;
    std::getline(text, line);
    const auto names = cells(line);
    std::vector<std::map<std::string, std::string>> lines;
    while (std::getline(text, line)) {
        const auto values = cells(line);
        EXPECT_EQ(values.size(), names.size()) << line;
        auto& cell = lines.emplace_back();
        for (std::size_t i = 0; i < values.size(); ++i) cell[names[i]] = values[i];
    }
    return lines;
}

TEST(Explain, OnePeakHaltsAtTheSeaAllAround) {
    Land land({{0, 100.0f}});
    land.features.starts[0].node = land.graph.node(50, 40);
    land.explain();
    const Field<Rgb8>& search = land.picture("search-00000");
    EXPECT_EQ(search(50, 40), kGenerator);
    EXPECT_EQ(count(search, kGenerator), 1);
    EXPECT_EQ(count(search, kFarBelow), 0);
    EXPECT_EQ(count(search, kBoth), 0);
    // It falls 10 m a cell from 200 m; 5 m are the sea, which begins at the 20th cell.
    for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        for (int i = 1; i < 20; ++i) {
            ASSERT_EQ(search(50 + i * dx, 40 + i * dy), kSearched) << i;
        }
        EXPECT_EQ(search(50 + 20 * dx, 40 + 20 * dy), kAtSea);
        EXPECT_EQ(search(50 + 21 * dx, 40 + 21 * dy), kElsewhere);
    }
    // A closed ring: nothing searched lies beside what was not.
    for (int y = 1; y < 79; ++y) {
        for (int x = 1; x < 99; ++x) {
            if (search(x, y) != kSearched) continue;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    ASSERT_NE(search(x + i, y + j), kElsewhere) << x << ", " << y;
        }
    }
}

// The pass of a low peak beside a high one halts on the other's flank.
TEST(Explain, ALowPeakHaltsUnderAHighOne) {
    Land land({{0, 0.0f}, {0, 230.0f}});
    land.features.starts[0].node = land.graph.node(45, 40);
    land.features.starts[1].node = land.graph.node(64, 40);
    land.halting = {.sea_level_threshold = 15.0f, .approximate_threshold = 0.15f};
    land.explain();
    const Field<Rgb8>& low = land.picture("search-00001");
    EXPECT_EQ(low(60, 40), kSearched);  // 30 m on land of 150
    EXPECT_EQ(low(59, 40), kFarBelow);  // 20 m, 160
    EXPECT_EQ(low(69, 40), kSearched);  // 20 m, 60
    EXPECT_EQ(low(70, 40), kAtSea);     // 10 m, 50
    EXPECT_GT(count(land.picture("search-00000"), kAtSea), 0);
    EXPECT_EQ(count(land.picture("search-00000"), kFarBelow), 0);
    EXPECT_EQ(land.picture("highest")(46, 40), distinct_colour(0));
}

TEST(Explain, HaltedForBothReasons) {
    Land land({{0, 0.0f}, {0, 270.0f}});
    land.features.starts[0].node = land.graph.node(45, 40);
    land.features.starts[1].node = land.graph.node(50, 40);
    land.halting = {.sea_level_threshold = 20.0f, .approximate_threshold = 0.10f};
    land.explain();
    // 20 m high on land of 260 m.
    EXPECT_EQ(land.picture("search-00001")(49, 40), kBoth);
}

TEST(Explain, TheTableAddsUpToThePasses) {
    Land land({{0, 0.0f}, {0, 240.0f}, {0, 100.0f}});
    land.features.starts[0].node = land.graph.node(45, 40);
    land.features.starts[1].node = land.graph.node(55, 40);
    land.features.starts[2].node = land.graph.node(10, 70);
    land.explain();
    std::size_t searched = 0;
    for (const auto& line : lines_of(land.shown.tables.at("features"))) {
        const std::string picture = "search-0000" + line.at("feature");
        const Field<Rgb8>& search = land.picture(picture);
        EXPECT_EQ(line.at("group"), "peaks");
        EXPECT_EQ(line.at("profile"), "");
        EXPECT_EQ(line.at("generators"), "1");
        EXPECT_EQ(std::stoi(line.at("halted_at_sea")), count(search, kAtSea));
        EXPECT_EQ(std::stoi(line.at("halted_far_below")), count(search, kFarBelow));
        EXPECT_EQ(std::stoi(line.at("halted_by_both")), count(search, kBoth));
        EXPECT_EQ(std::stoi(line.at("searched")), 8000 - count(search, kElsewhere));
        searched += std::stoul(line.at("searched"));
    }
    EXPECT_EQ(searched, land.counts.features);
}

TEST(Explain, CostsOfAFeature) {
    Land land({{0, 40.0f}});
    land.features.starts.push_back({land.graph.node(11, 10), 60.0f});
    land.features.starts[0].node = land.graph.node(10, 10);
    land.features.first = {0, 2};
    land.explain();
    const auto line = lines_of(land.shown.tables.at("features")).at(0);
    EXPECT_EQ(line.at("least_cost"), "40.000");
    EXPECT_EQ(line.at("mean_cost"), "50.000");
    EXPECT_EQ(line.at("generators"), "2");
}

TEST(Explain, AFewSearchesOfManyEvenlyChosen) {
    std::vector<Start> starts;
    for (int i = 0; i < 60; ++i) starts.push_back({0, 250.0f});
    Land land(starts);
    for (int i = 0; i < 60; ++i) {
        land.features.starts[i].node = land.graph.node(20 + i, 40);
    }
    land.explain();
    EXPECT_EQ(land.shown.searches(), Explainer::kSearches);
    for (const char* name : {"search-00000", "search-00005", "search-00055"}) {
        EXPECT_TRUE(land.shown.pictures.contains(name)) << name;
    }
}

TEST(Explain, NeighbouringNumbersHaveColoursApart) {
    for (int i = 0; i < 300; ++i) {
        for (int j = 1; j <= 5; ++j) {
            const Rgb8 a = distinct_colour(i), b = distinct_colour(i + j);
            const int apart =
                std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
            EXPECT_GE(apart, 60) << i << " and " << i + j;
        }
    }
}

TEST(Explain, VisitsOfOneAndTwoPasses) {
    Land land({{0, 100.0f}, {0, 100.0f}});
    land.features.starts[0].node = land.graph.node(40, 40);
    land.features.starts[1].node = land.graph.node(60, 40);
    land.explain();
    const Field<Rgb8>& visits = land.picture("visits");
    EXPECT_EQ(visits(50, 40), (Rgb8{255, 255, 255}));
    EXPECT_EQ(visits(30, 40), visits(70, 40));
    EXPECT_NE(visits(30, 40), visits(50, 40));
    EXPECT_EQ(visits(5, 5), (Rgb8{0, 0, 0}));
    const Field<Rgb8>& approximate = land.picture("approximate");
    EXPECT_EQ(approximate(40, 40), (Rgb8{255, 255, 255}));
    EXPECT_EQ(approximate(30, 40), (Rgb8{128, 128, 128}));  // halfway down
}

TEST(Explain, ProfilesOfGeneratorsAndRegions) {
    Land land({{0, 100.0f}, {0, 200.0f}});
    land.features.starts[0].node = land.graph.node(40, 40);
    land.features.starts[1].node = land.graph.node(60, 40);
    land.features.features[1].profile = 0;
    land.options.profiles.resize(1);
    land.options.profiles[0].name = "cone";
    land.regions.profile_at.assign(land.graph.nodes(), Regions::kFree);
    land.regions.profile_at[land.graph.node(5, 5)] = 0;
    land.explain();
    const Field<Rgb8>& profiles = land.picture("profiles");
    EXPECT_EQ(profiles(60, 40), distinct_colour(0));
    EXPECT_NE(profiles(40, 40), distinct_colour(0));
    EXPECT_NE(profiles(5, 5), profiles(7, 7));
    EXPECT_EQ(land.picture("features")(60, 40), distinct_colour(1));
    EXPECT_GT(land.picture("costs")(40, 40)[2], land.picture("costs")(60, 40)[2]);
    EXPECT_EQ(lines_of(land.shown.tables.at("features")).at(1).at("profile"), "cone");
}

// Explains a whole stage.
struct Stage {
    Options options;
    Shown shown;

    Stage() {
        Peaks where;
        where.placement.count = 20;
        options.groups.resize(1);
        options.groups[0].name = "low, \"green\" hills";
        options.groups[0].where = where;
    }
    Terrain run(bool explain) {
        SilentProgress silent;
        Context context;
        context.progress = &silent;
        if (explain) context.explain = &shown.sinks;
        Terrain flat;
        flat.heights = Field<float>(128, 128);
        flat.spacing = 40.0;
        return distance::run(options, flat, context);
    }
};

TEST(Explain, TheLandIsTheSame) {
    Stage stage;
    EXPECT_EQ(stage.run(true).heights, stage.run(false).heights);
    for (const char* name :
         {"features", "profiles", "costs", "approximate", "visits", "highest"}) {
        EXPECT_TRUE(stage.shown.pictures.contains(name)) << name;
    }
    EXPECT_EQ(stage.shown.searches(), 12);
    EXPECT_NE(stage.shown.tables.at("features").find(",\"low, \"\"green\"\" hills\",,1,"),
              std::string::npos);
}

TEST(Explain, TheSameForAnyNumberOfThreads) {
    Stage one, four;
    {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
        one.run(true);
    }
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 4);
    four.run(true);
    EXPECT_EQ(one.shown.tables, four.shown.tables);
    EXPECT_TRUE(one.shown.pictures == four.shown.pictures);
}

TEST(Explain, APreviewHasNoPasses) {
    Stage stage;
    stage.options.preview = true;
    stage.run(true);
    EXPECT_TRUE(stage.shown.pictures.contains("approximate"));
    EXPECT_EQ(stage.shown.searches(), 0);
    EXPECT_TRUE(stage.shown.tables.empty());
}

}  // namespace
}  // namespace cydonia::distance
