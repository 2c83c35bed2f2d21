// Maps of terrain types in the formats of geographic information systems, written here by
// GDAL itself.
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <fstream>

#include "config/reader/map.h"
#include "field/random.h"
#include "tests/field/temporary_folder.h"

namespace cydonia::config {
namespace {

using genetic::MapOptions;
using genetic::Outline;

struct Drawn {
    std::string type, name, wkt;
};

const Outline kTriangle = {{0.0, 0.0}, {10.0, 0.0}, {0.0, 5.0}};
const std::vector<Drawn> kMap = {
    {"plain", "low", "POLYGON ((0 0,0 4,4 4,4 0,0 0),(1 1,2 1,2 2,1 1))"},
    {"high hills", "", "MULTIPOLYGON (((4 0,4 4,8 4,4 0)),((20 0,20 1,21 1,20 0)))"}};

struct OgrMap : testing::Test {
    TemporaryFolder folder;
    genetic::LibraryOptions library;
    OgrMap() {
        GDALAllRegister();
        library.types = {{.name = "plain", .examples = {}},
                         {.name = "high hills", .examples = {}}};
    }
    // Writes one layer; `field` is the attribute that holds the types.
    void write(const std::filesystem::path& file, const char* driver,
               const std::vector<Drawn>& features, const char* field = "type",
               OGRwkbGeometryType geometry = wkbUnknown) const {
        GDALDriver* d = GetGDALDriverManager()->GetDriverByName(driver);
        ASSERT_TRUE(d);
        GDALDataset* dataset = d->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
        ASSERT_TRUE(dataset);
        OGRLayer* layer = dataset->CreateLayer("map", nullptr, geometry, nullptr);
        OGRFieldDefn type(field, OFTString), name("name", OFTString);
        ASSERT_EQ(layer->CreateField(&type), OGRERR_NONE);
        ASSERT_EQ(layer->CreateField(&name), OGRERR_NONE);
        for (const Drawn& drawn : features) {
            OGRFeature feature(layer->GetLayerDefn());
            feature.SetField(0, drawn.type.c_str());
            if (!drawn.name.empty()) feature.SetField(1, drawn.name.c_str());
            OGRGeometry* shape = nullptr;
            OGRGeometryFactory::createFromWkt(drawn.wkt.c_str(), nullptr, &shape);
            feature.SetGeometryDirectly(shape);
            ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
        }
        GDALClose(dataset);
    }
};

// A file name and the driver that writes it.
struct OgrFormat : OgrMap,
                   testing::WithParamInterface<std::pair<const char*, const char*>> {
    std::filesystem::path written(const std::vector<Drawn>& features,
                                  const char* field = "type") const {
        const auto file = folder / GetParam().first;
        write(file, GetParam().second, features, field,
              file.extension() == ".shp" ? wkbPolygon : wkbUnknown);
        return file;
    }
};

TEST_P(OgrFormat, RegionsWithHolesPartsAndNames) {
    const MapOptions map = load_map(written(kMap), library);
    ASSERT_EQ(map.regions.size(), 2u);
    EXPECT_EQ(map.regions[0].type, "plain");
    EXPECT_EQ(map.regions[0].name, "low");
    ASSERT_EQ(map.regions[0].outlines.size(), 2u);
    EXPECT_EQ(map.regions[0].outlines[0].size(), 4u);  // without the first again
    EXPECT_EQ(map.regions[0].outlines[1].size(), 3u);
    EXPECT_EQ(map.regions[1].type, "high hills");
    EXPECT_EQ(map.regions[1].name, "high hills");
    EXPECT_EQ(map.regions[1].outlines.size(), 2u);
    EXPECT_EQ(map.window, (std::array{0.0, 0.0, 21.0, 4.0}));
}

TEST_P(OgrFormat, TypesMayBeCalledTerrain) {
    const MapOptions map = load_map(written(kMap, "Terrain"), library);
    EXPECT_EQ(map.regions.at(1).type, "high hills");
}

TEST_P(OgrFormat, APolygonWithoutATypeIsNamed) {
    const auto file = written({kMap[0], {"", "", kMap[0].wkt}});
    expect_error(ExitCode::kBadRequest, "feature 2: it needs an attribute 'type'",
                 [&] { load_map(file, library); });
    expect_error(ExitCode::kBadRequest, "feature 1: it needs an attribute 'type'",
                 [&] { load_map(written(kMap, "kind"), library); });
}

// Whatever the damage, the answer is a map or our own message.
TEST_P(OgrFormat, SpoiltBytesEndInAMapOrAMessage) {
    const std::string good = read_text(written(kMap));
    const auto file = folder / (std::string("spoilt-") + GetParam().first);
    for (const char* beside : {".dbf", ".shx"}) {  // of a Shapefile
        auto from = folder / GetParam().first, to = file;
        from.replace_extension(beside), to.replace_extension(beside);
        if (std::filesystem::exists(from)) std::filesystem::copy_file(from, to);
    }
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
        std::string bad = good;
        for (std::uint64_t i = 0; i <= seed % 8; ++i) {
            const std::uint64_t h = hash_of({seed, i});
            if (seed % 5 == 0)
                bad.resize(h % bad.size() + 1);
            else
                bad[h % bad.size()] = char(mix(h));
        }
        std::ofstream(file, std::ios::binary) << bad;
        survives([&] { load_map(file, library); });
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, OgrFormat,
                         testing::Values(std::pair{"m.geojson", "GeoJSON"},
                                         std::pair{"m.shp", "ESRI Shapefile"},
                                         std::pair{"m.gpkg", "GPKG"}),
                         [](const auto& format) {
                             const std::string file = format.param.first;
                             return file.substr(file.find('.') + 1);
                         });

TEST_F(OgrMap, TheGeometryIsTheSameInEveryFormat) {
    const std::vector<Drawn> features = {{"plain", "", "POLYGON ((0 0,10 0,0 5,0 0))"}};
    write(folder / "m.geojson", "GeoJSON", features);
    write(folder / "m.gpkg", "GPKG", features);
    for (const char* name : {"m.geojson", "m.gpkg"})
        EXPECT_EQ(load_map(folder / name, library).regions.at(0).outlines.at(0),
                  kTriangle)
            << name;
}

TEST_F(OgrMap, PointsLinesAndFeaturesWithoutGeometryAreLeftOut) {
    write(folder / "m.gpkg", "GPKG",
          {{"summit", "", "POINT (1 1)"},
           {"road", "", "LINESTRING (0 0,1 1)"},
           {"", "", "POLYGON EMPTY"},
           kMap[0]});
    EXPECT_EQ(load_map(folder / "m.gpkg", library).regions.size(), 1u);
}

TEST_F(OgrMap, CurvesBecomeLines) {
    write(folder / "m.gpkg", "GPKG",
          {{"plain", "", "CURVEPOLYGON (CIRCULARSTRING (0 0,1 1,2 0,1 -1,0 0))"}});
    EXPECT_GT(load_map(folder / "m.gpkg", library).regions.at(0).outlines.at(0).size(),
              20u);
}

// A Shapefile is several files: the types stand in the .dbf.
TEST_F(OgrMap, AShapefileWithoutItsCompanions) {
    write(folder / "m.shp", "ESRI Shapefile", kMap, "type", wkbPolygon);
    std::filesystem::remove(folder / "m.shx");
    expect_error(ExitCode::kBadRequest, "m.shx",
                 [&] { load_map(folder / "m.shp", library); });
    write(folder / "n.shp", "ESRI Shapefile", kMap, "type", wkbPolygon);
    std::filesystem::remove(folder / "n.dbf");
    expect_error(ExitCode::kBadRequest, "n.shp: feature 1: it needs an attribute 'type'",
                 [&] { load_map(folder / "n.shp", library); });
}

TEST_F(OgrMap, OtherFilesUnderTheseNames) {
    for (const char* name : {"m.shp", "m.gpkg", "m.geojson"}) {
        const auto file = folder.with(name, "v 0 0\n");
        expect_error(ExitCode::kBadRequest, std::string(name) + ": GDAL cannot read it",
                     [&] { load_map(file, library); });
    }
}

}  // namespace
}  // namespace cydonia::config
