#include "field/packaged.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "field/dem.h"
#include "field/error.h"
#include "tests/field/temporary_folder.h"

namespace cydonia {
namespace {

// Both packages are listed in packages.txt.

TEST(Packaged, JacksboroIsADissectedPlateau) {
    std::string note;
    const Terrain terrain = read_dem(open_packaged_dem("jacksboro"), &note);
    const auto [low, high] = std::ranges::minmax(terrain.heights);
    EXPECT_NEAR(terrain.width(), 30e3, 300.0);
    EXPECT_NEAR(terrain.depth(), 31.8e3, 300.0);
    EXPECT_NEAR(low, 236.0, 8.0);
    EXPECT_NEAR(high, 1076.0, 8.0);
    EXPECT_FALSE(note.empty());
}

TEST(Packaged, TopographyIsASmoothFell) {
    const Terrain terrain = read_dem(open_packaged_dem("topography"));
    const auto [low, high] = std::ranges::minmax(terrain.heights);
    EXPECT_EQ(terrain.spacing, 20.0);
    ASSERT_EQ(terrain.heights.width(), 400);
    EXPECT_NEAR(low, 180.001, 1e-3);
    EXPECT_NEAR(high, 530.605, 1e-3);
}

TEST(Packaged, EveryNameOpens) {
    for (const std::string& name : packaged_dems())
        EXPECT_TRUE(is_packaged_dem(open_packaged_dem(name).path)) << name;
}

TEST(Packaged, UnknownName) {
    expect_error(ExitCode::kBadRequest, "'alps'", [] { open_packaged_dem("alps"); });
}

TEST(Packaged, AStrangersDescriptionIsNotFollowed) {
    const TemporaryFolder folder;
    const auto copy = folder / "jacksboro.vrt";
    std::filesystem::copy_file(open_packaged_dem("jacksboro").path, copy);
    expect_error(ExitCode::kBadRequest, "not an elevation model",
                 [&] { read_dem(open_source(copy)); });
}

}  // namespace
}  // namespace cydonia
