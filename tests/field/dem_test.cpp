#include "field/dem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "field/image.h"
#include "tests/field/raster.h"
#include "tests/field/small_disk.h"

namespace cydonia {
namespace {

namespace fs = std::filesystem;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr const char* kUtm = "EPSG:32632";  // metres

// A model with height(x, y) in every cell. Cells are squares of 10 m unless changed.
template <class Height>
Raster raster_of(int width, int height, const Height& height_at) {
    Raster raster{width, height, {{}}, {500000, 10, 0, 5100000, 0, -10}, kUtm};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) raster.bands[0].push_back(float(height_at(x, y)));
    return raster;
}

float slope_of(int x, int y) { return 100.0f + 3.0f * float(x) + 2.0f * float(y); }

struct Read {
    Terrain terrain;
    std::string note;
};

Read read(const fs::path& path) {
    Read result;
    result.terrain = read_dem(open_source(path), &result.note);
    return result;
}

Read read(const Raster& raster, const std::vector<const char*>& options = {}) {
    const TemporaryFolder folder;
    return read(write_tiff(folder / "a.tif", raster, options));
}

void expect_refused(const Raster& raster, std::string_view words) {
    expect_error(ExitCode::kBadRequest, words, [&] { read(raster); });
    expect_error(ExitCode::kBadRequest, "a.tif: ", [&] { read(raster); });
}

TEST(ReadDem, SquareMetresAreKeptToTheBit) {
    const Raster raster = raster_of(7, 5, slope_of);
    const auto [terrain, note] = read(raster);
    EXPECT_EQ(terrain.spacing, 10.0);
    ASSERT_EQ(terrain.heights.width(), 7);
    EXPECT_TRUE(std::equal(terrain.heights.begin(), terrain.heights.end(),
                           raster.bands[0].begin(), raster.bands[0].end()));
    EXPECT_EQ(note, "");
}

TEST(ReadDem, TerrainGeoTiffReadsBack) {
    const TemporaryFolder folder;
    Terrain terrain;
    terrain.spacing = 12.5;
    terrain.heights = Field<float>(30, 20);
    std::mt19937 random(1);
    for (float& height : terrain.heights) height = float(random()) / 1e6f - 2000.0f;
    write_geotiff(folder / "a.tif", terrain);
    const auto [again, note] = read(folder / "a.tif");
    EXPECT_EQ(again.heights, terrain.heights);
    EXPECT_EQ(again.spacing, terrain.spacing);
    EXPECT_EQ(note, "");
}

TEST(ReadDem, GeoTiffStandsAtTheSouthWestCorner) {
    const TemporaryFolder folder;
    Terrain terrain;
    terrain.spacing = 2.0;
    terrain.heights = Field<float>(30, 20);
    write_geotiff(folder / "a.tif", terrain);
    const QuietGdal quiet;
    const Dataset file(GDALDataset::Open((folder / "a.tif").c_str()));
    std::array<double, 6> transform{};
    file->GetGeoTransform(transform.data());
    EXPECT_EQ(transform, (std::array{0.0, 2.0, 0.0, 40.0, 0.0, -2.0}));
    EXPECT_EQ(file->GetSpatialRef()->GetLinearUnits(), 1.0);
}

TEST(ReadDem, TerrainExrReadsBack) {
    const TemporaryFolder folder;
    const Field<float> heights(4, 3, 12.5f);
    write_exr(folder / "a.exr", heights, "Y", {{"cydonia:spacing", "7.5"}});
    EXPECT_EQ(read(folder / "a.exr").terrain.heights, heights);
    EXPECT_EQ(read(folder / "a.exr").terrain.spacing, 7.5);
    write_exr(folder / "b.exr", heights, "Y");
    write_exr(folder / "c.exr", heights, "Y", {{"cydonia:spacing", "-3"}});
    for (const char* name : {"b.exr", "c.exr"})
        expect_error(ExitCode::kBadRequest, "no attribute cydonia:spacing",
                     [&] { read(folder / name); });
}

TEST(ReadDem, FewVoidsAreInterpolated) {
    // One void of each kind: declared, not a number, infinite, undeclared.
    for (const float hole : {-5000.0f, kNan, INFINITY, -32768.0f, -9999.0f, -3.4e38f}) {
        Raster raster = raster_of(30, 20, slope_of);
        raster.no_data = -5000.0;
        raster.bands[0][10 * 30 + 15] = hole;
        raster.bands[0][0] = hole;
        const auto [terrain, note] = read(raster);
        EXPECT_NEAR(terrain.heights(15, 10), slope_of(15, 10), 1.0f) << hole;
        EXPECT_NEAR(terrain.heights(0, 0), slope_of(0, 0), 5.0f) << hole;
        EXPECT_EQ(terrain.heights(14, 10), slope_of(14, 10));
        EXPECT_EQ(note, "2 cells without a height (0.33%) were interpolated");
    }
}

TEST(ReadDem, VoidsAreNamedWhenAskedFor) {
    const TemporaryFolder folder;
    const auto hole = [](int x, int y) { return x < 12 || (x == 15 && y == 10); };
    const Raster raster = raster_of(
        20, 30, [&](int x, int y) { return hole(x, y) ? kNan : slope_of(x, y); });
    write_tiff(folder / "a.tif", raster);
    Field<std::uint8_t> voids;
    const Terrain terrain = read_dem(open_source(folder / "a.tif"), nullptr, &voids);
    ASSERT_TRUE(voids.same_shape(terrain.heights));
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 20; ++x) EXPECT_EQ(voids(x, y), hole(x, y)) << x << ' ' << y;
    write_tiff(folder / "b.tif", raster_of(20, 30, slope_of));
    read_dem(open_source(folder / "b.tif"), nullptr, &voids);
    EXPECT_TRUE(voids.empty());
}

TEST(ReadDem, VoidsMoveWithTheirLand) {
    // In the far north cells in degrees are warped to cells of another shape.
    Raster raster = raster_of(60, 60, slope_of);
    raster.transform = {10.0, 0.002, 0, 60.0, 0, -0.001};
    raster.plane = "EPSG:4326";
    for (int y = 0; y < 60; ++y)
        for (int x = 40; x < 60; ++x) raster.bands[0][std::size_t(60 * y + x)] = kNan;
    const TemporaryFolder folder;
    write_tiff(folder / "a.tif", raster);
    Field<std::uint8_t> voids;
    const Terrain terrain = read_dem(open_source(folder / "a.tif"), nullptr, &voids);
    ASSERT_TRUE(voids.same_shape(terrain.heights));
    const int width = voids.width(), middle = voids.height() / 2;
    EXPECT_EQ(voids(width / 2, middle), 0);
    EXPECT_EQ(voids(width * 3 / 4, middle), 1);
    EXPECT_EQ(voids(width - 1, middle), 1);
}

TEST(ReadDem, ManyVoidsAreRefusedWithTheirShare) {
    expect_refused(raster_of(20, 10, [](int x, int) { return x < 5 ? kNan : 1.0f; }),
                   "25.0% of its cells have no height");
    expect_refused(raster_of(20, 10, [](int, int) { return kNan; }),
                   "100.0% of its cells have no height");
}

TEST(ReadDem, OblongCellsBecomeSquares) {
    Raster raster = raster_of(80, 60, [](int x, int y) { return 8 * x - 5 * y; });
    raster.transform = {500000, 8, 0, 5100000, 0, -5};  // one metre up a metre east
    const auto [terrain, note] = read(raster);
    const double spacing = std::sqrt(40.0);
    EXPECT_NEAR(terrain.spacing, spacing, 1e-9);
    EXPECT_EQ(terrain.heights.width(), int(640 / spacing));
    EXPECT_EQ(terrain.heights.height(), int(300 / spacing));
    for (int y = 5; y < 40; ++y)
        for (int x = 5; x < 90; ++x) {
            EXPECT_NEAR(terrain.heights(x + 1, y) - terrain.heights(x, y), spacing, 0.05);
            EXPECT_NEAR(terrain.heights(x, y + 1) - terrain.heights(x, y), -spacing,
                        0.05);
        }
    EXPECT_NE(note.find("cells of 8 x 5 m were resampled to squares of 6.325 m"),
              note.npos);
}

// A cone on the ground in geographic coordinates, with the axes of an ellipsoid at a
// latitude, must come out round and as steep as it is.
TEST(ReadDem, GeographicConeComesOutRound) {
    const double latitude = 60.0, step = 1.0 / 1200.0;  // 3 arc seconds
    const double north = 111412.24 * step,
                 east = 55800.0 * step;  // metres a cell at 60 N
    Raster raster = raster_of(240, 160, [&](int x, int y) {
        return 3000.0 - 0.5 * std::hypot((x - 119.5) * east, (y - 79.5) * north);
    });
    raster.transform = {10.0 - 120 * step, step, 0, latitude + 80 * step, 0, -step};
    raster.plane = "EPSG:4326";
    const auto [terrain, note] = read(raster);
    EXPECT_NEAR(terrain.spacing, std::sqrt(east * north), 0.1);
    const double cx = 0.5 * (terrain.heights.width() - 1);
    const double cy = 0.5 * (terrain.heights.height() - 1);
    for (int y = 0; y < terrain.heights.height(); ++y)
        for (int x = 0; x < terrain.heights.width(); ++x) {
            const double away = terrain.spacing * std::hypot(x - cx, y - cy);
            if (away <= 300.0) continue;  // the tip is rounded
            ASSERT_NEAR(terrain.heights(x, y), 3000.0 - 0.5 * away, 0.005 * away)
                << x << "," << y;
        }
    EXPECT_NE(note.find("were warped to squares of"), note.npos);
}

TEST(ReadDem, WebMercatorIsBroughtToTrueSize) {
    Raster raster = raster_of(60, 60, [](int, int) { return 1.0f; });
    raster.plane = "EPSG:3857";
    raster.transform = {1113194.9, 100, 0,
                        8399737.9, 0,   -100};  // at 60 N, twice too large
    EXPECT_NEAR(read(raster).terrain.spacing, 50.0, 0.3);
}

TEST(ReadDem, MarsHasItsOwnSize) {
    Raster raster = raster_of(60, 60, [](int, int) { return 1.0f; });
    raster.plane =
        "GEOGCS[\"Mars\",DATUM[\"Mars\",SPHEROID[\"Mars\",3396190,0]],PRIMEM[\"0\",0],"
        "UNIT[\"degree\",0.0174532925199433]]";
    raster.transform = {10, 0.01, 0, 0.3, 0, -0.01};
    EXPECT_NEAR(read(raster).terrain.spacing, 592.7, 0.1);
}

TEST(ReadDem, FeetBecomeMetres) {
    Raster raster = raster_of(4, 4, [](int, int) { return 100.0f; });
    raster.plane = "EPSG:2229";  // US survey feet
    raster.transform = {6500000, 100, 0, 1900000, 0, -100};
    raster.unit = "ft";
    const auto [terrain, note] = read(raster);
    EXPECT_NEAR(terrain.spacing, 30.48006, 1e-5);
    EXPECT_NEAR(terrain.heights(1, 1), 30.48, 1e-4);
}

TEST(ReadDem, ScaleAndOffsetAreApplied) {
    Raster raster = raster_of(4, 4, [](int x, int) { return float(x); });
    raster.scale = 0.5;
    raster.offset = -10.0;
    EXPECT_FLOAT_EQ(read(raster).terrain.heights(3, 0), -8.5f);
}

TEST(ReadDem, OddUnitAndMoreBandsAreNoted) {
    Raster raster = raster_of(4, 4, slope_of);
    raster.bands.push_back(std::vector<float>(16, 7.0f));
    raster.unit = "ells";
    const auto [terrain, note] = read(raster);
    EXPECT_EQ(terrain.heights(1, 1), slope_of(1, 1));
    EXPECT_EQ(
        note,
        "of its 2 bands the first was used; its unit of height, 'ells', was taken for "
        "metres");
}

TEST(ReadDem, SouthUpIsTurnedOver) {
    Raster raster = raster_of(3, 4, slope_of);
    raster.transform = {500000, 10, 0, 5000000, 0, 10};
    const auto [terrain, note] = read(raster);
    EXPECT_EQ(terrain.heights(0, 0), slope_of(0, 3));
    EXPECT_EQ(terrain.heights(2, 3), slope_of(2, 0));
}

TEST(ReadDem, LocalMetresWithoutACoordinateSystem) {
    Raster raster = raster_of(5, 5, slope_of);
    raster.plane = nullptr;
    EXPECT_EQ(read(raster).terrain.spacing, 10.0);
}

TEST(ReadDem, RefusedWithTheReason) {
    Raster raster = raster_of(5, 5, slope_of);
    raster.transform = {};
    raster.plane = nullptr;
    expect_refused(raster, "it has no coordinates");
    raster.transform = {10, 0.001, 0, 50, 0, -0.001};
    expect_refused(raster, "look like degrees");
    raster.plane = kUtm;
    raster.transform = {500000, 7, 7, 5100000, 7, -7};
    expect_refused(raster, "turned or mirrored");
    raster.plane = "EPSG:4326";
    raster.transform = {-180, 72, 0, 90, 0, -36};
    expect_refused(raster, "it spans 360 x 180 degrees");
    raster.transform = {0, 1, 0, 95, 0, -1};
    EXPECT_FALSE(survives([&] { read(raster); }));
    raster = raster_of(1, 9, slope_of);
    expect_refused(raster, "1 x 9 heights, fewer than 2 x 2");
    raster = raster_of(16385, 2, slope_of);
    expect_refused(raster, "16385 x 2 heights, more than 16384 x 16384");
}

TEST(ReadDem, FilesThatAreNoModel) {
    const TemporaryFolder folder;
    expect_error(ExitCode::kBadRequest, "not an elevation model",
                 [&] { read(folder.with("a.tif", "text")); });
    // A virtual raster may name any file or address, and is therefore not read.
    const fs::path tiff = write_tiff(folder / "b.tif", raster_of(4, 4, slope_of));
    const std::string vrt = fmt::format(
        "<VRTDataset rasterXSize='4' rasterYSize='4'><VRTRasterBand dataType='Float32' "
        "band='1'><SimpleSource><SourceFilename>{}</SourceFilename></SimpleSource>"
        "</VRTRasterBand></VRTDataset>",
        tiff.string());
    expect_error(ExitCode::kBadRequest, "not an elevation model",
                 [&] { read(folder.with("a.vrt", vrt)); });
}

TEST(ReadDem, OtherFormats) {
    const TemporaryFolder folder;
    const Raster raster = raster_of(12, 12, slope_of);
    write_copy(folder / "a.asc", "AAIGrid", raster);
    const auto [terrain, note] = read(folder / "a.asc");
    EXPECT_EQ(terrain.spacing, 10.0);
    EXPECT_EQ(terrain.heights(5, 7), slope_of(5, 7));
}

TEST(ReadDem, TruncatedOrDamagedAnywhere) {
    const TemporaryFolder folder;
    std::mt19937 random(2);
    Raster raster = raster_of(64, 64, [&](int, int) { return float(random() % 1000); });
    for (const char* compress : {"COMPRESS=NONE", "COMPRESS=DEFLATE"}) {
        const std::string bytes =
            read_text(write_tiff(folder / "a.tif", raster, {compress}));
        for (std::size_t length = 1; length < bytes.size(); length += 1 + length / 16) {
            write_text(folder / "cut.tif", bytes.substr(0, length));
            EXPECT_FALSE(survives([&] { read(folder / "cut.tif"); })) << length;
        }
        for (int i = 0; i < 200; ++i) {
            std::string changed = bytes;
            for (int k = 0; k < 3; ++k)
                changed[random() % (i % 2 ? bytes.size() : 600)] = char(random());
            write_text(folder / "hurt.tif", changed);
            survives([&] { read(folder / "hurt.tif"); });
        }
    }
}

TEST(WriteGeotiff, FullDiskLeavesNothingBehind) {
    const TemporaryFolder folder;
    Terrain terrain;
    terrain.heights = Field<float>(128, 128);
    std::mt19937 random(3);
    for (float& height : terrain.heights) height = float(random());
    const SmallDisk disk(16384);
    expect_error(ExitCode::kFailed, "a.tif: File too large",
                 [&] { write_geotiff(folder / "a.tif", terrain); });
    EXPECT_TRUE(folder.is_empty());
}

struct Exemplar {
    const char* name;
    int width, height;
    double spacing, low, high;
};

// The formats that the README lists.
TEST(ReadDem, Exemplars) {
    const fs::path folder = fs::path(CYDONIA_SOURCE_DIR) / "../shared/exemplars";
    if (!fs::exists(folder)) GTEST_SKIP() << "the exemplar models are not here";
    const Exemplar exemplars[] = {{"andes_aconcagua", 960, 1024, 90, 296, 6086},
                                  {"atacama_coast", 320, 640, 90, 0, 1892},
                                  {"canberra_hills", 940, 1140, 90, 15, 1598},
                                  {"catalan_ranges", 860, 760, 90, 37, 1197},
                                  {"jacksboro_fault", 320, 340, 90, 237, 1075},
                                  {"lapland_fell", 400, 400, 20, 180, 531},
                                  {"moon_farside", 1024, 1024, 473.8, -3312, 7331},
                                  {"mount_st_helens", 317, 460, 30, 694, 2543},
                                  {"north_german_plain", 640, 640, 90, 23, 319},
                                  {"olympic_coast", 1280, 1024, 30, 0, 809},
                                  {"pyrenees_andorra", 840, 900, 90, 397, 3096},
                                  {"san_gabriel", 1197, 643, 30, 315, 2295},
                                  {"southern_uplands", 640, 1024, 90, -2, 816},
                                  {"thuringian_slate", 730, 1160, 90, 134, 1043}};
    for (const Exemplar& exemplar : exemplars) {
        const auto [terrain, note] = read(folder / (std::string(exemplar.name) + ".tif"));
        const auto [low, high] = std::ranges::minmax_element(terrain.heights);
        EXPECT_EQ(terrain.heights.width(), exemplar.width) << exemplar.name;
        EXPECT_EQ(terrain.heights.height(), exemplar.height) << exemplar.name;
        EXPECT_NEAR(terrain.spacing, exemplar.spacing, 0.01) << exemplar.name;
        EXPECT_NEAR(*low, exemplar.low, 0.6) << exemplar.name;
        EXPECT_NEAR(*high, exemplar.high, 0.6) << exemplar.name;
        EXPECT_EQ(note, "") << exemplar.name;
    }
}

}  // namespace
}  // namespace cydonia
