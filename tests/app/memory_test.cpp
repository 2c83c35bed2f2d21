#include "app/pipeline/memory.h"

#include <gtest/gtest.h>

#include "field/dem.h"
#include "field/error.h"
#include "tests/app/program.h"

using namespace cydonia;

TEST(Memory, GrowsWithTheCells) {
    const StageOptions stage = distance::Options{};
    EXPECT_GT(memory::of_stage(stage, 4096 * 4096, 2),
              memory::of_stage(stage, 512 * 512, 2));
    EXPECT_GT(memory::of_stage(stage, 512 * 512, 8),
              memory::of_stage(stage, 512 * 512, 2));
    EXPECT_GT(memory::of_trace(512 * 512, 1920 * 1080), memory::of_trace(512 * 512, 1));
}

TEST(Memory, RemembersNoPassesOfAPreviewAndNotAllOfALargeOne) {
    distance::Options options;
    const auto needed = [&](std::uint64_t cells) {
        return memory::of_stage(options, cells, 1);
    };
    const std::uint64_t small = needed(512 * 512), large = needed(4096 * 4096);
    options.preview = true;
    EXPECT_EQ(small - needed(512 * 512), 2 * 200 * 512 * 512u);
    EXPECT_EQ(large - needed(4096 * 4096), 2 * 268'000'000u);
}

TEST(Memory, OfLandFromExemplarsGrowsWithThemToo) {
    const test::TemporaryFolder folder;
    write_geotiff(folder / "a.tif", {Field<float>(1000, 800), 30.0, {}, {}, {}});
    texture::Options options;
    const auto needed = [&](std::uint64_t cells) {
        return memory::of_stage(options, cells, 2);
    };
    const std::uint64_t without = needed(2048 * 2048), little = needed(1);
    options.exemplars.push_back({open_source(folder / "a.tif"), {}, {}});
    EXPECT_EQ(needed(2048 * 2048) - without, 43 * 800'000u);
    EXPECT_NEAR(double(needed(1) - little), 130 * 800'000, 100);
    const std::uint64_t free = needed(2048 * 2048);
    options.coherent = true;
    EXPECT_EQ(needed(2048 * 2048) - free, 135 * 2048 * 2048u);
}

TEST(Memory, OfDetailsGrowsWithTargetsAndTheirOrientations) {
    const test::TemporaryFolder folder;
    write_geotiff(folder / "a.tif", {Field<float>(1000, 800), 30.0, {}, {}, {}});
    detail::Options options;
    const auto needed = [&] { return memory::of_stage(options, 2048 * 2048, 2); };
    const std::uint64_t without = needed();
    options.targets.push_back({open_source(folder / "a.tif"), {}});
    EXPECT_EQ(needed() - without, 40 * 800'000u);
    options.orientations = 8;
    EXPECT_EQ(needed() - without, (24 + 8 * 16) * 800'000u);
}

TEST(Memory, OfATileIsThatOfItsSizeWhateverTheLandHas) {
    const StageOptions texture = texture::Options{};
    const std::vector<const StageOptions*> stages{&texture};
    const auto tile = [&](int side) {
        return memory::of_tile(stages, {65536, 65536, 10.0}, side, side, 2);
    };
    EXPECT_GT(tile(2048), memory::of_stage(texture, 2048 * 2048, 2));
    EXPECT_LT(tile(2048), 1'000'000'000u);
    EXPECT_LT(tile(256), tile(2048));
}

// Details depend on land as far as their blocks reach, which are shares of the land.
TEST(Memory, OfATileWithDetailsGrowsWithTheLand) {
    const StageOptions texture = texture::Options{}, detail = detail::Options{};
    const std::vector<const StageOptions*> plain{&texture}, stages{&texture, &detail};
    const auto tile = [&](const auto& of, int side) {
        return memory::of_tile(of, {side, side, 10.0}, 512, 512, 2);
    };
    EXPECT_EQ(tile(plain, 8192), tile(plain, 16384));
    EXPECT_GT(tile(stages, 16384), tile(stages, 8192));
}

TEST(Memory, TheMachineHasSome) {
    EXPECT_GT(memory::available(), 1'000'000u);
    EXPECT_LT(memory::available(), 1ull << 50);
}

TEST(Memory, RefusalNamesBothFigures) {
    EXPECT_NO_THROW(memory::refuse_unless_it_fits(5, 5));
    try {
        memory::refuse_unless_it_fits(2'400'000'000, 310'000'000);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kFailed);
        EXPECT_NE(std::string(error.what()).find("2.4 GB"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("310 MB"), std::string::npos);
    }
}
