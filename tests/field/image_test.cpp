#include "field/image.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <numeric>
#include <random>

#include "tests/field/raster.h"
#include "tests/field/small_disk.h"

namespace cydonia {
namespace {

namespace fs = std::filesystem;

Field<float> ramp(int width, int height) {
    Field<float> image(width, height);
    std::iota(image.begin(), image.end(), -100.5f);
    return image;
}

TEST(Png, SixteenBitsKeepEveryLevel) {
    const TemporaryFolder folder;
    Field<std::uint16_t> levels(256, 256);
    std::iota(levels.begin(), levels.end(), 0);
    write_png(folder / "h.png", levels);

    const Field<float> read = read_grey(open_source(folder / "h.png"));
    const std::vector<float> stored = band_of(folder / "h.png");
    ASSERT_TRUE(read.same_shape(levels));
    for (std::size_t i = 0; i < levels.size(); ++i) {
        ASSERT_EQ(stored[i], float(levels[i]));
        ASSERT_EQ(std::lround(read[i] * 65535.0f), levels[i]);
    }
}

TEST(Png, GreyAndColourKeepTheirBytes) {
    const TemporaryFolder folder;
    Field<std::uint8_t> grey(16, 16);
    std::iota(grey.begin(), grey.end(), std::uint8_t{0});
    write_png(folder / "g.png", grey);
    const Field<Rgba8> read = read_rgba(open_source(folder / "g.png"));
    for (std::size_t i = 0; i < grey.size(); ++i)
        ASSERT_EQ(read[i], (Rgba8{grey[i], grey[i], grey[i], 255}));

    write_png(folder / "c.png", Field<Rgb8>(3, 2, {7, 130, 255}));
    EXPECT_EQ(read_rgba(open_source(folder / "c.png")),
              Field<Rgba8>(3, 2, {7, 130, 255, 255}));
}

TEST(Exr, KeepsEveryFloat) {
    const TemporaryFolder folder;
    Field<float> values(4, 2);
    const float chosen[] = {0.0f,     -0.0f,       1e-42f,   -3.4e38f,
                            65536.7f, 1.0f / 3.0f, INFINITY, NAN};
    std::copy(std::begin(chosen), std::end(chosen), values.begin());
    write_exr(folder / "f.exr", values, "Y");
    const Field<float> read = read_exr(folder / "f.exr");
    ASSERT_TRUE(read.same_shape(values));
    EXPECT_EQ(std::memcmp(read.data(), values.data(), values.size() * sizeof(float)), 0);
}

TEST(Exr, KeepsItsMetadata) {
    const TemporaryFolder folder;
    const Metadata written{{"cydonia:seed", "7"},
                           {"cydonia:title", "TEXT, \"é\"\nby sun"}};
    write_exr(folder / "f.exr", ramp(3, 3), "height", written);
    Metadata read;
    read_exr(folder / "f.exr", &read);
    for (const auto& [name, value] : written) EXPECT_EQ(read[name], value) << name;
}

TEST(Exr, ColourIsHalfAndSaysWhichLight) {
    const TemporaryFolder folder;
    const Field<Rgb> rgb(5, 3, {0.5f, 0.25f, 1024.0f});
    write_exr(folder / "a.exr", rgb, {}, Primaries::kAcesCg);
    write_exr(folder / "b.exr", rgb);
    EXPECT_EQ(read_exr_rgb(folder / "a.exr"), rgb);
    EXPECT_EQ(read_exr_rgb(folder / "b.exr"), rgb);
    EXPECT_NE(read_text(folder / "a.exr").find("chromaticities"), std::string::npos);
    EXPECT_EQ(read_text(folder / "b.exr").find("chromaticities"), std::string::npos);
}

// The bytes must not depend on the date.
TEST(Exr, CarriesNoDate) {
    const TemporaryFolder folder;
    write_exr(folder / "a.exr", ramp(40, 30), "Y");
    Metadata read;
    read_exr(folder / "a.exr", &read);
    EXPECT_EQ(read["DateTime"], "");
}

TEST(Exr, WrongChannels) {
    const TemporaryFolder folder;
    write_exr(folder / "c.exr", Field<Rgb>(2, 2));
    write_exr(folder / "f.exr", ramp(2, 2), "Y");
    expect_error(ExitCode::kBadRequest, "c.exr: 3 channels",
                 [&] { read_exr(folder / "c.exr"); });
    expect_error(ExitCode::kBadRequest, "f.exr: 1 channels",
                 [&] { read_exr_rgb(folder / "f.exr"); });
}

TEST(ReadGrey, OverWhiteWhereTransparent) {
    const TemporaryFolder folder;
    const Raster raster{2, 1, {{0, 0}, {0, 0}, {0, 0}, {0, 255}}, {}, nullptr, GDT_Byte};
    const Source source = open_source(write_copy(folder / "a.png", "PNG", raster));
    EXPECT_EQ(read_grey(source)(0, 0), 1.0f);
    EXPECT_EQ(read_grey(source)(1, 0), 0.0f);
}

TEST(ReadRgba, ColoursStayAsStoredUnderAlpha) {
    const TemporaryFolder folder;
    const Raster raster{1, 1, {{200}, {100}, {50}, {128}}, {}, nullptr, GDT_Byte};
    const Source source = open_source(write_copy(folder / "a.png", "PNG", raster));
    EXPECT_EQ(read_rgba(source)(0, 0), (Rgba8{200, 100, 50, 128}));
}

TEST(Images, AreToldApartByWhatTheyHold) {
    const TemporaryFolder folder;
    const Raster raster{32, 32, {std::vector<float>(1024, 99.0f)}, {}, nullptr, GDT_Byte};
    write_copy(folder / "really-a-jpeg.png", "JPEG", raster);
    EXPECT_EQ(read_rgba(open_source(folder / "really-a-jpeg.png"))(9, 9),
              (Rgba8{99, 99, 99, 255}));
    folder.with("text.png", "not an image at all");
    folder.with("short.png", "\x89P");
    for (const char* name : {"text.png", "short.png"})
        expect_error(ExitCode::kBadRequest, "not a PNG, JPEG, TIFF, OpenEXR or PNM image",
                     [&] { read_rgba(open_source(folder / name)); });
}

TEST(Images, HugeSizeIsRefusedBeforeItIsAllocated) {
    const TemporaryFolder folder;
    const auto header = [](int width) {
        std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
        for (int shift = 24; shift >= 0; shift -= 8) bytes += char(width >> shift & 255);
        bytes += std::string("\0\0\x40\0\x10\0\0\0\0", 9);  // 16384 rows, 16 bits
        return bytes;
    };
    // Two right checksums, so that the sizes are accepted.
    folder.with("wide.png", header(16385) + "\xe2\x6b\x4b\xb1" + std::string(4, '\0') +
                                "IEND\xae\x42\x60\x82");
    const auto start = std::chrono::steady_clock::now();
    expect_error(ExitCode::kBadRequest, "wide.png",
                 [&] { read_rgba(open_source(folder / "wide.png")); });
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(200));

    write_tiff(folder / "wide.tif",
               {16385, 1, {std::vector<float>(16385)}, {}, nullptr, GDT_Byte});
    expect_error(ExitCode::kBadRequest, "16385 x 1 pixels, more than 16384 x 16384",
                 [&] { read_rgba(open_source(folder / "wide.tif")); });
}

// The same image in every format that can be read.
std::vector<fs::path> every_format(const TemporaryFolder& folder) {
    std::mt19937 random(1);
    std::vector<float> noise(96 * 64);
    for (float& value : noise) value = float(random() % 256);
    const Raster grey{96, 64, {noise}, {}, nullptr, GDT_Byte};
    write_exr(folder / "a.exr", ramp(96, 64), "Y");
    return {write_copy(folder / "a.png", "PNG", grey),
            write_copy(folder / "a.jpg", "JPEG", grey),
            write_tiff(folder / "lines.tif", grey, {"COMPRESS=DEFLATE"}),
            write_tiff(folder / "tiles.tif", grey,
                       {"TILED=YES", "BLOCKXSIZE=32", "BLOCKYSIZE=32"}),
            folder / "a.exr"};
}

TEST(Images, TruncatedAnywhere) {
    const TemporaryFolder folder;
    for (const fs::path& path : every_format(folder)) {
        const std::string bytes = read_text(path);
        ASSERT_TRUE(survives([&] { read_rgba(open_source(path)); })) << path;
        const fs::path cut = folder / ("cut" + path.extension().string());
        for (std::size_t length = 1; length < bytes.size(); length += 1 + length / 16) {
            write_text(cut, bytes.substr(0, length));
            expect_error(ExitCode::kBadRequest, cut.string(),
                         [&] { read_rgba(open_source(cut)); });
            expect_error(ExitCode::kBadRequest, cut.string(),
                         [&] { read_grey(open_source(cut)); });
        }
    }
}

TEST(Images, DamagedAnywhere) {
    const TemporaryFolder folder;
    std::mt19937 random(2);
    for (const fs::path& path : every_format(folder)) {
        const std::string bytes = read_text(path);
        const fs::path hurt = folder / ("hurt" + path.extension().string());
        for (int i = 0; i < 40; ++i) {
            std::string changed = bytes;
            const std::size_t span =
                i % 2 ? bytes.size() : std::min<std::size_t>(400, bytes.size());
            for (int k = 0; k < 3; ++k) changed[random() % span] = char(random());
            write_text(hurt, changed);
            survives([&] { read_rgba(open_source(hurt)); });
        }
    }
}

TEST(Images, FullDiskLeavesNothingBehind) {
    const TemporaryFolder folder;
    Field<std::uint16_t> noise(256, 256);
    std::mt19937 random(3);
    for (auto& level : noise) level = std::uint16_t(random());
    Field<float> values(256, 256);
    std::copy(noise.begin(), noise.end(), values.begin());

    const SmallDisk disk(16384);
    expect_error(ExitCode::kFailed, "a.png: File too large",
                 [&] { write_png(folder / "a.png", noise); });
    expect_error(ExitCode::kFailed, "a.exr: File too large",
                 [&] { write_exr(folder / "a.exr", values, "Y"); });
    expect_error(ExitCode::kFailed, "missing/a.exr: No such file",
                 [&] { write_exr(folder / "missing/a.exr", values, "Y"); });
    EXPECT_TRUE(folder.is_empty());
}

TEST(Resized, SameSizeIsTheSame) { EXPECT_EQ(resized(ramp(5, 7), 5, 7), ramp(5, 7)); }

TEST(Resized, ConstantStaysConstant) {
    for (const auto& [width, height] :
         {std::pair(3, 3), std::pair(7, 29), std::pair(40, 1)})
        for (const float value : resized(Field<float>(10, 13, 0.7f), width, height))
            EXPECT_FLOAT_EQ(value, 0.7f);
}

TEST(Resized, ShrinkingKeepsTheMean) {
    std::mt19937 random(4);
    Field<float> image(50, 31);
    for (float& value : image) value = float(random() % 1000);
    const auto mean = [](const Field<float>& f) {
        return std::accumulate(f.begin(), f.end(), 0.0) / double(f.size());
    };
    EXPECT_NEAR(mean(resized(image, 7, 9)), mean(image), 1e-3);
    EXPECT_NEAR(resized(image, 1, 1)(0, 0), mean(image), 1e-3);
}

TEST(Resized, ShrinkingAveragesWhatACellCovers) {
    Field<float> image(3, 1);
    image(1, 0) = 3.0f;  // two cells of 1.5 pixels
    const Field<float> cells = resized(image, 2, 1);
    EXPECT_FLOAT_EQ(cells(0, 0), 1.0f);
    EXPECT_FLOAT_EQ(cells(1, 0), 1.0f);
}

TEST(Resized, GrowingIsLinearBetweenCentres) {
    Field<float> image(2, 1);
    image(1, 0) = 1.0f;
    const Field<float> cells = resized(image, 4, 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_FLOAT_EQ(cells(x, y), std::clamp(0.5f * float(x) - 0.25f, 0.0f, 1.0f));
}

}  // namespace
}  // namespace cydonia
