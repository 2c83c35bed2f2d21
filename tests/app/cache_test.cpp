#include "app/pipeline/cache.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/app/program.h"

namespace fs = std::filesystem;
using namespace cydonia;

namespace {

Terrain small_land() {
    Terrain land{Field<float>(5, 3, 12.5f), 20.0, {}, {}, {}};
    land.heights(4, 2) = -1.0f;
    land.masks["sea"] = Field<float>(5, 3, 0.25f);
    ShadowImage image{"text", Field<std::uint8_t>(5, 3, 1), {1.0, 0.5}, 0.9};
    image.target(0, 0) = 0;
    image.window = Field<std::uint8_t>(5, 3, 1);
    image.relaxed = Field<std::uint8_t>(5, 3);
    image.window(1, 0) = 0;
    image.relaxed(2, 1) = 1;
    land.shadows = {image};
    land.figures = {{"rim: error, m", 1.25}, {"share", -0.0}};
    land.pictures["sources"] = Field<Rgb8>(7, 2, Rgb8{1, 2, 3});
    land.pictures["sources"](6, 1) = {255, 0, 9};
    return land;
}

std::string bytes_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST(Cache, GivesBackTheWholeTerrain) {
    const test::TemporaryFolder folder;
    const Terrain land = small_land();
    store_terrain(folder / "a.terrain", land);
    const auto back = load_terrain(folder / "a.terrain");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->heights, land.heights);
    EXPECT_EQ(back->spacing, land.spacing);
    EXPECT_EQ(back->masks, land.masks);
    ASSERT_EQ(back->shadows.size(), 1u);
    EXPECT_EQ(back->shadows[0].name, "text");
    EXPECT_EQ(back->shadows[0].target, land.shadows[0].target);
    EXPECT_EQ(back->shadows[0].sun, land.shadows[0].sun);
    EXPECT_EQ(back->shadows[0].min_iou, 0.9);
    EXPECT_EQ(back->shadows[0].window, land.shadows[0].window);
    EXPECT_EQ(back->shadows[0].relaxed, land.shadows[0].relaxed);
    EXPECT_EQ(back->figures, land.figures);
    EXPECT_EQ(back->pictures, land.pictures);
}

TEST(Cache, MissingFile) {
    const test::TemporaryFolder folder;
    EXPECT_FALSE(load_terrain(folder / "none.terrain"));
}

TEST(Cache, CutShortAnywhere) {
    const test::TemporaryFolder folder;
    store_terrain(folder / "a.terrain", small_land());
    const std::string bytes = bytes_of(folder / "a.terrain");
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        folder.write("cut.terrain", bytes.substr(0, size));
        EXPECT_FALSE(load_terrain(folder / "cut.terrain")) << size;
    }
}

TEST(Cache, AnyByteDamaged) {
    const test::TemporaryFolder folder;
    store_terrain(folder / "a.terrain", small_land());
    const std::string bytes = bytes_of(folder / "a.terrain");
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string damaged = bytes;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x40);
        folder.write("bad.terrain", damaged);
        EXPECT_FALSE(load_terrain(folder / "bad.terrain")) << i;
    }
}

// Sizes that lie, under a checksum that is right.
TEST(Cache, SizesBeyondTheFile) {
    const test::TemporaryFolder folder;
    store_terrain(folder / "a.terrain", small_land());
    std::string bytes = bytes_of(folder / "a.terrain");
    const std::size_t body = bytes.size() - 8 - bytes.find('\n') - 1;
    const std::size_t begin = bytes.size() - body;
    for (std::size_t i = 0; i < body; ++i) {
        std::string lying = bytes;
        lying[begin + i] = '\xff';
        const std::uint64_t checksum = hash_text(std::string_view(lying).substr(begin));
        lying.replace(begin - 8, 8, reinterpret_cast<const char*>(&checksum), 8);
        folder.write("lie.terrain", lying);
        load_terrain(folder / "lie.terrain");  // may succeed; must not crash
    }
}

TEST(Cache, PruningKeepsTheLastUsed) {
    const test::TemporaryFolder folder;
    const auto now = fs::file_time_type::clock::now();
    for (int i = 0; i < 4; ++i) {
        const fs::path file = cached_terrain(folder.path(), i);
        store_terrain(file, small_land());
        fs::last_write_time(file, now - std::chrono::hours(i));
    }
    const std::uint64_t size = fs::file_size(cached_terrain(folder.path(), 0));
    prune_terrains(folder.path(), 2 * size);
    EXPECT_TRUE(fs::exists(cached_terrain(folder.path(), 0)));
    EXPECT_TRUE(fs::exists(cached_terrain(folder.path(), 1)));
    EXPECT_FALSE(fs::exists(cached_terrain(folder.path(), 2)));
    prune_terrains(folder.path(), 0);
    EXPECT_TRUE(fs::exists(cached_terrain(folder.path(), 0)));
}
