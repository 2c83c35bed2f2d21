#include "field/tiled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "field/dem.h"
#include "field/error.h"
#include "field/files.h"
#include "field/image.h"
#include "tests/field/small_disk.h"
#include "tests/field/temporary_folder.h"

namespace fs = std::filesystem;
using namespace cydonia;

namespace {

constexpr TiledShape kShape{700, 560, 30.0};

Field<float> land(const TiledShape& shape = kShape) {
    Field<float> heights(shape.width, shape.height);
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x)
            heights(x, y) =
                500.0f * std::sin(0.01f * float(x)) * std::cos(0.013f * float(y));
    return heights;
}

Field<float> part(const Field<float>& of, int x, int y, int side) {
    Field<float> cut(std::min(side, of.width() - x), std::min(side, of.height() - y));
    for (int j = 0; j < cut.height(); ++j)
        for (int i = 0; i < cut.width(); ++i) cut(i, j) = of(x + i, y + j);
    return cut;
}

// Writes the parts from the south-east, so that no writer can depend on an order.
void write_parts(TiledFile& file, const Field<float>& heights, int side) {
    for (int y = (heights.height() - 1) / side * side; y >= 0; y -= side)
        for (int x = (heights.width() - 1) / side * side; x >= 0; x -= side)
            file.write(x, y, part(heights, x, y, side));
    file.close();
}

std::string bytes_of(const fs::path& file) { return read_text(file); }

using Open = std::unique_ptr<TiledFile> (*)(const fs::path&);
struct Format {
    const char* name;
    Open open;
};
const Format kFormats[] = {
    {"land.tif", [](const fs::path& path) { return tiled_geotiff(path, kShape); }},
    {"land.exr",
     [](const fs::path& path) {
         return tiled_exr(path, kShape, {{"cydonia:spacing", "30"}});
     }},
};

struct Tiled : testing::Test {
    TemporaryFolder folder;
};

}  // namespace

TEST_F(Tiled, PartsMakeTheWhole) {
    for (const int side : {256, 512, 1024})
        for (const Format& format : kFormats) {
            const fs::path path = folder.path() / format.name;
            write_parts(*format.open(path), land(), side);
            EXPECT_EQ(read_dem(open_source(path)).heights, land()) << path << side;
        }
}

TEST_F(Tiled, SaysWhereItLiesAsUntiledFilesDo) {
    const Terrain terrain{land(), kShape.spacing, {}, {}, {}};
    write_geotiff(folder.path() / "whole.tif", terrain);
    write_parts(*kFormats[0].open(folder.path() / "parts.tif"), land(), 256);
    const Terrain whole = read_dem(open_source(folder.path() / "whole.tif"));
    const Terrain parts = read_dem(open_source(folder.path() / "parts.tif"));
    EXPECT_EQ(whole.spacing, parts.spacing);
    EXPECT_EQ(whole.heights, parts.heights);
}

TEST_F(Tiled, ExrKeepsMetadata) {
    const fs::path path = folder.path() / "land.exr";
    write_parts(*kFormats[1].open(path), land(), 256);
    Metadata metadata;
    read_exr(path, &metadata);
    EXPECT_EQ(metadata["cydonia:spacing"], "30");
}

TEST_F(Tiled, SamePartsGiveTheSameBytes) {
    for (const Format& format : kFormats) {
        const fs::path one = folder.path() / format.name;
        const fs::path two = folder.path() / (std::string("again-") + format.name);
        write_parts(*format.open(one), land(), 256);
        write_parts(*format.open(two), land(), 256);
        EXPECT_EQ(bytes_of(one), bytes_of(two)) << format.name;
    }
}

// The disk is full at various sizes of the file.
TEST_F(Tiled, FullDiskIsNoticed) {
    for (const Format& format : kFormats) {
        const fs::path path = folder.path() / format.name;
        write_parts(*format.open(path), land(), 256);
        const auto size = fs::file_size(path);
        for (std::uintmax_t room = 1; room < size; room += size / 7) {
            fs::remove(path);
            const SmallDisk disk(room);
            EXPECT_THROW(write_parts(*format.open(path), land(), 256), Error)
                << format.name << " " << room << " of " << size;
        }
        fs::remove(path);
        const SmallDisk disk(size - 1);
        EXPECT_THROW(write_parts(*format.open(path), land(), 256), Error) << format.name;
    }
}

TEST_F(Tiled, FolderThatIsNotThere) {
    for (const Format& format : kFormats)
        EXPECT_THROW(format.open(folder.path() / "none" / format.name), Error);
}

TEST_F(Tiled, TileComesBackUnderItsKeyOnly) {
    const fs::path path = folder.path() / "tile.tif";
    const Field<float> tile = part(land(), 512, 256, 256);
    write_tile(path, tile, 512, 256, kShape, "abc");
    EXPECT_TRUE(holds_tile(path, 188, 256, "abc"));
    EXPECT_EQ(read_tile(path, 188, 256, "abc"), tile);
    EXPECT_EQ(read_tile(path, 188, 256, "abd"), std::nullopt);
    EXPECT_EQ(read_tile(path, 188, 255, "abc"), std::nullopt);
    EXPECT_EQ(read_tile(folder.path() / "none.tif", 188, 256, "abc"), std::nullopt);
    EXPECT_FALSE(holds_tile(folder.path(), 188, 256, "abc"));
}

TEST_F(Tiled, DamagedTileIsNone) {
    const fs::path path = folder.path() / "tile.tif";
    write_tile(path, part(land(), 0, 0, 256), 0, 0, kShape, "abc");
    const std::string good = bytes_of(path);
    for (std::size_t i = 7; i < good.size(); i += good.size() / 61) {
        write_text(path, good.substr(0, i));
        EXPECT_EQ(read_tile(path, 256, 256, "abc"), std::nullopt) << i;
    }
    std::string bad = good;
    for (std::size_t i = good.size() / 2; i < good.size() / 2 + 64; ++i)
        bad[i] = static_cast<char>(bad[i] ^ 0x55);
    write_text(path, bad);
    EXPECT_EQ(read_tile(path, 256, 256, "abc"), std::nullopt);
}
