// What synth/method.h promises: a method is its own folder and one alternative.
#include "synth/stage.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace cydonia {

// A method that is nowhere but here: a slope that rises by `rise` metres a column.
namespace slope {

struct Options {
    double rise = 1.0;
};

Field<float> tile(const Options& options, const Extent&, const Context&, int x, int,
                  int width, int height) {
    Field<float> heights(width, height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            heights(column, row) = static_cast<float>(options.rise * (x + column));
    return heights;
}

Terrain run(const Options& options, const Terrain& terrain, const Context& context) {
    Terrain result = terrain;
    const int width = terrain.heights.width(), height = terrain.heights.height();
    result.heights =
        tile(options, {width, height, terrain.spacing}, context, 0, 0, width, height);
    return result;
}

Method method_of(const Options&) { return {.name = "slope", .version = 7}; }

std::uint64_t peak_memory(const Options&, std::uint64_t cells, std::uint64_t threads) {
    return 4 * cells + threads;
}

int reach(const Options&, const Extent&) { return 5; }

}  // namespace slope

// One that changes the land before it, and looks one column to the east.
namespace shifted {

struct Options {};

Field<float> tile(const Options&, const Extent&, const Heights& before, const Context&,
                  int x, int y, int width, int height) {
    return before(x + 1, y, width, height);
}

Terrain run(const Options&, const Terrain& terrain, const Context&) { return terrain; }

Method method_of(const Options&) {
    return {.name = "shifted", .version = 1, .makes_land = false};
}

std::uint64_t peak_memory(const Options&, std::uint64_t cells, std::uint64_t) {
    return cells;
}

int reach(const Options&, const Extent&) { return 1; }

}  // namespace shifted

// One that was begun and left.
namespace forgetful {

struct Options {};

Terrain run(const Options&, const Terrain& terrain, const Context&) { return terrain; }

}  // namespace forgetful

namespace {

using Stage = std::variant<slope::Options, shifted::Options, dem::Options>;

TEST(Stage, AMethodIsFoundByItsOptionsAlone) {
    static_assert(is_method<slope::Options>());
    const Stage stage = slope::Options{2.0};
    EXPECT_EQ(method_of(stage).name, "slope");
    EXPECT_EQ(method_of(stage).version, 7);
    EXPECT_TRUE(method_of(stage).makes_land);
    EXPECT_FALSE(method_of(stage).follows_memory);
    EXPECT_EQ(peak_memory(stage, 100, 3), 403u);
    Terrain flat;
    flat.heights = Field<float>(4, 3);
    EXPECT_EQ(run(stage, flat, {}).heights(3, 2), 6.0f);
}

TEST(Stage, TilesGoThroughAllStages) {
    const Stage first = slope::Options{2.0}, second = shifted::Options{};
    const std::vector<const Stage*> stages{&first, &second, &second};
    const std::span<const Stage* const> all(stages);
    const Extent extent{100, 100, 1.0};
    EXPECT_EQ(reach(all, extent), 7);
    std::vector<int> asked;
    const auto context = [&](int stage) {
        asked.push_back(stage);
        return Context{};
    };
    const Field<float> land = tile(all, extent, context, 10, 20, 3, 2);
    EXPECT_EQ(land.width(), 3);
    EXPECT_EQ(land(0, 0), 24.0f);
    EXPECT_EQ(asked, (std::vector{2, 1, 0}));
}

TEST(Stage, WhatIsMadeWholeHasNoTiles) {
    const Stage model = dem::Options{};
    const std::vector<const Stage*> stages{&model};
    const auto context = [](int) { return Context{}; };
    EXPECT_THROW(
        tile(std::span<const Stage* const>(stages), {9, 9, 1.0}, context, 0, 0, 1, 1),
        std::logic_error);
}

// is_method() names each of these in its error.
TEST(Stage, WhatAMethodForgetsIsKnown) {
    static_assert(Runs<forgetful::Options>);
    static_assert(!SaysWhatItIs<forgetful::Options>);
    static_assert(!PredictsMemory<forgetful::Options>);
    static_assert(!Tiles<forgetful::Options>);
    static_assert(TilesOfNothing<slope::Options> && !TilesOfLand<slope::Options>);
    static_assert(TilesOfLand<shifted::Options>);
}

template <std::size_t... I>
std::vector<StageOptions> one_of_each(std::index_sequence<I...>) {
    return {StageOptions(std::in_place_index<I>)...};
}

template <class Options>
constexpr bool has_tiles(const Options&) {
    return Tiles<Options>;
}

TEST(Stage, EveryMethodSaysWhatItIs) {
    const std::vector<StageOptions> stages =
        one_of_each(std::make_index_sequence<std::variant_size_v<StageOptions>>());
    std::set<std::string_view> names;
    for (const StageOptions& stage : stages) {
        const Method method = method_of(stage);
        EXPECT_TRUE(names.insert(method.name).second) << method.name;
        EXPECT_GT(method.version, 0) << method.name;
        EXPECT_GT(peak_memory(stage, 1'000'000, 2), 1'000'000u) << method.name;
        const bool tiles = std::visit([](const auto& o) { return has_tiles(o); }, stage);
        EXPECT_EQ(tiles, method.whole_because.empty()) << method.name;
    }
}

}  // namespace
}  // namespace cydonia
