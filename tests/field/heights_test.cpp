// Heights in files for other programs, read by GDAL or, for EXR, by OpenImageIO.
#include "field/heights_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "field/error.h"
#include "field/files.h"
#include "tests/field/raster.h"
#include "tests/field/temporary_folder.h"

using namespace cydonia;

namespace {

constexpr int kWidth = 9, kHeight = 6;

// Rough land whose north-western corner is highest and whose south-eastern corner is
// lowest.
Terrain corner_land() {
    Terrain land{Field<float>(kWidth, kHeight), 12.5, {}, {}, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            land.heights(x, y) = -20.25f + float((x * 7 + y * 5) % 11);
    land.heights(0, 0) = 950.5f;
    land.heights(kWidth - 1, 0) = 300.0f;
    land.heights(0, kHeight - 1) = 100.0f;
    land.heights(kWidth - 1, kHeight - 1) = -400.75f;
    return land;
}

// Reads a file without a header through a description for GDAL.
std::vector<float> raw_band(const std::filesystem::path& path, const char* type,
                            int bytes) {
    const auto vrt = path.string() + ".vrt";
    write_text(vrt, fmt::format(R"(<VRTDataset rasterXSize="{0}" rasterYSize="{1}">
<VRTRasterBand dataType="{2}" band="1" subClass="VRTRawRasterBand">
<SourceFilename relativeToVRT="1">{3}</SourceFilename><ImageOffset>0</ImageOffset>
<PixelOffset>{4}</PixelOffset><LineOffset>{5}</LineOffset><ByteOrder>LSB</ByteOrder>
</VRTRasterBand></VRTDataset>)",
                                kWidth, kHeight, type, path.filename().string(), bytes,
                                bytes * kWidth));
    return band_of(vrt);
}

std::vector<float> exr_values(const std::filesystem::path& path) {
    const auto file = OIIO::ImageInput::open(path.string());
    if (!file || file->spec().width != kWidth) return {};
    std::vector<float> values(kWidth * kHeight);
    EXPECT_TRUE(file->read_image(0, 0, 0, 1, OIIO::TypeFloat, values.data()));
    return values;
}

std::vector<float> values_of(const std::filesystem::path& path, HeightFormat format) {
    if (format == HeightFormat::kRaw16) return raw_band(path, "UInt16", 2);
    if (format == HeightFormat::kRaw32) return raw_band(path, "Float32", 4);
    if (format == HeightFormat::kExr) return exr_values(path);
    return band_of(path);
}

struct Heights : testing::Test {
    TemporaryFolder folder;
    const Terrain land = corner_land();

    std::filesystem::path path_of(HeightFormat format) const {
        return folder / fmt::format("land.{}", extension_of(format));
    }
    StoredHeights write(HeightFormat format) const {
        return write_heights(path_of(format), land, format);
    }
};

constexpr HeightFormat kAll[] = {
    HeightFormat::kTer,   HeightFormat::kTif, HeightFormat::kPng16, HeightFormat::kRaw16,
    HeightFormat::kRaw32, HeightFormat::kExr, HeightFormat::kXyz};

}  // namespace

// Every sample must be in its place; a rotated or mirrored file fails at the corners.
TEST_F(Heights, OffsetAndScaleGiveTheMetresToAnotherReader) {
    for (const HeightFormat format : kAll) {
        SCOPED_TRACE(name_of(format));
        const StoredHeights stored = write(format);
        const auto values = values_of(path_of(format), format);
        ASSERT_EQ(values.size(), land.heights.size());
        const bool exact = stored.type == "float32" || stored.type == "decimal";
        // GDAL rounds Terragen's levels down.
        const double steps = format == HeightFormat::kTer ? 1.01 : 0.51;
        const double error = exact ? 0.0 : steps * stored.scale;
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(stored.offset + stored.scale * double(values[i]),
                        double(land.heights[i]), error)
                << i;
        EXPECT_EQ(double(std::ranges::max(values)), stored.highest);
        EXPECT_EQ(double(std::ranges::min(values)), stored.lowest);
        // 16 bits span the heights: a step is little more than a 65536th of them.
        if (!exact) {
            EXPECT_LT(stored.scale, 1351.25 / 65535.0 * 1.3);
        }
    }
}

TEST_F(Heights, RowsLieInTheFileAsSaid) {
    const auto first = [&](HeightFormat format) {
        return write(format).from_south ? kHeight - 1 : 0;
    };
    // Terragen's heights are in units of its spacing: base + scale * value / 65536.
    const int row = first(HeightFormat::kTer);
    EXPECT_EQ(row, kHeight - 1);
    const std::string ter = read_text(path_of(HeightFormat::kTer));
    const std::size_t at = ter.find("ALTW");
    ASSERT_NE(at, ter.npos);
    std::int16_t scale, base, value;
    std::memcpy(&scale, ter.data() + at + 4, 2);
    std::memcpy(&base, ter.data() + at + 6, 2);
    std::memcpy(&value, ter.data() + at + 8, 2);
    EXPECT_NEAR(12.5 * (base + value * scale / 65536.0), double(land.heights(0, row)),
                0.05);

    EXPECT_EQ(first(HeightFormat::kRaw32), 0);
    const std::string raw = read_text(path_of(HeightFormat::kRaw32));
    float north_west;
    std::memcpy(&north_west, raw.data(), 4);
    EXPECT_EQ(north_west, 950.5f);
    EXPECT_EQ(raw.size(), 4u * kWidth * kHeight);
}

TEST_F(Heights, TextIsAtTheCellsCentres) {
    write(HeightFormat::kXyz);
    const std::string text = read_text(path_of(HeightFormat::kXyz));
    EXPECT_TRUE(text.starts_with("6.25 68.75 950.5\n18.75 68.75 "));
    EXPECT_TRUE(text.ends_with("\n106.25 6.25 -400.75\n"));
}

TEST_F(Heights, GeoreferencedWhereTheFormatCan) {
    for (const HeightFormat format : {HeightFormat::kTif, HeightFormat::kXyz}) {
        SCOPED_TRACE(name_of(format));
        write(format);
        const QuietGdal quiet;
        const Dataset file(GDALDataset::Open(path_of(format).c_str()));
        ASSERT_TRUE(file);
        std::array<double, 6> place{};
        file->GetGeoTransform(place.data());
        EXPECT_EQ(place, (std::array<double, 6>{0.0, 12.5, 0.0, 75.0, 0.0, -12.5}));
    }
}

TEST_F(Heights, FlatLandIsWrittenToo) {
    const Terrain flat{Field<float>(4, 4, 7.5f), 10.0, {}, {}, {}};
    for (const HeightFormat format : kAll) {
        SCOPED_TRACE(name_of(format));
        const StoredHeights stored = write_heights(path_of(format), flat, format);
        EXPECT_NEAR(stored.offset + stored.scale * stored.lowest, 7.5, 1e-2);
    }
}

TEST_F(Heights, TextThatNobodyCouldOpenIsRefused) {
    const Terrain large{Field<float>(kMostXyzSamples + 1, 2), 1.0, {}, {}, {}};
    EXPECT_THROW(write_heights(folder / "a.xyz", large, HeightFormat::kXyz), Error);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.xyz"));
}
