#include "config/reader/map.h"

#include <algorithm>

#include "config/reader/library.h"
#include "tests/config/scene_file.h"

namespace cydonia::config {
namespace {

class Maps : public SceneFile {
  protected:
    Maps() { library_ = load_library(folder_ / "kinds.toml"); }

    genetic::MapOptions map(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return load_map(folder_ / name, library_);
    }
    std::string wrong(const std::string& name, const std::string& text) {
        try {
            map(name, text);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::kBadRequest);
            return std::string(error.what()).substr(folder_.string().size() + 1);
        }
        return {};
    }

    genetic::LibraryOptions library_;
};

using Box = std::array<double, 4>;

TEST_F(Maps, TheThesisOwn) {
    const auto m = map("a.map",
                       "# Map vertices\nv -700.0 -700.0 # 1\nv 0 -700\nv 0 700\n\n"
                       "tt high_hills\nf 1 2 3\nv 700 700\ntt plain\nf -2 -1 2\n");
    ASSERT_EQ(m.regions.size(), 2u);
    EXPECT_EQ(m.regions[0].type, "high hills");
    EXPECT_EQ(m.regions[1].outlines[0],
              (genetic::Outline{{0.0, 700.0}, {700.0, 700.0}, {0.0, -700.0}}));
    EXPECT_EQ(m.window, (Box{-700.0, -700.0, 700.0, 700.0}));
}

TEST_F(Maps, TheThesisOwnWrong) {
    EXPECT_EQ(wrong("a.map", "v 1\n"), "a.map:1: a corner is 'v EAST NORTH'");
    EXPECT_EQ(wrong("a.map", "v 1 nan\n"), "a.map:1: a corner is 'v EAST NORTH'");
    EXPECT_EQ(wrong("a.map", "v 0 0\nv 1 1\nf 1 2 1\n"),
              "a.map:3: a face needs a terrain type before it: tt NAME");
    EXPECT_EQ(wrong("a.map", "v 0 0\ntt plain\nf 1 2 3\n"),
              "a.map:3: there is no corner '2' yet, of 1");
    EXPECT_EQ(wrong("a.map", "v 0 0\ntt plain\nf 1 0 1\n"),
              "a.map:3: there is no corner '0' yet, of 1");
    EXPECT_EQ(wrong("a.map", "v 0 0\ntt plain\nf 1 1\n"),
              "a.map:3: a face has at least three corners");
    EXPECT_EQ(wrong("a.map", "vt 0 0\n"),
              "a.map:1: unknown record 'vt'; known: v, tt, f");
    EXPECT_EQ(wrong("a.map", "# nothing\n"),
              "a.map: it has no regions; give at least one outline with a terrain type");
    EXPECT_EQ(wrong("a.txt", "v 0 0\n"),
              "a.txt: a map is a .toml, .svg, .geojson, .shp, .gpkg or .map file");
}

TEST_F(Maps, Toml) {
    const auto m = map("a.toml",
                       "window = [0, 0, 10, 20]\nsmoothness = 0.1\n[[region]]\n"
                       "type = \"plain\"\noutline = [[0, 0], [10, 0], [10, 20]]\n");
    EXPECT_EQ(m.window, (Box{0.0, 0.0, 10.0, 20.0}));
    EXPECT_EQ(m.smoothness, 0.1);
    EXPECT_EQ(m.regions.at(0).name, "plain");
    EXPECT_NE(
        wrong("a.toml", "[[region]]\ntype = \"plain\"\n").find("missing key 'outline'"),
        std::string::npos);
    EXPECT_NE(wrong("a.toml", "[[region").find("a.toml:1:"), std::string::npos);
}

TEST_F(Maps, GeoJson) {
    const auto m = map("a.geojson", R"({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"type": "plain", "name": "meadow"}, "geometry":
         {"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4],[0,4],[0,0]],
                                             [[1,1],[2,1],[2,2],[1,1]]]}},
        {"type": "Feature", "properties": {}, "geometry": {"type": "Point",
         "coordinates": [1, 1]}},
        {"type": "Feature", "properties": {"terrain": "high_hills"}, "geometry":
         {"type": "MultiPolygon", "coordinates": [[[[4,0],[8,0],[8,4],[4,0]]]]}}]})");
    ASSERT_EQ(m.regions.size(), 2u);
    EXPECT_EQ(m.regions[0].name, "meadow");
    EXPECT_EQ(m.regions[0].outlines.size(), 2u);
    EXPECT_EQ(m.regions[0].outlines[1].size(), 3u);
    EXPECT_EQ(m.regions[1].type, "high hills");
    EXPECT_EQ(m.window, (Box{0.0, 0.0, 8.0, 4.0}));
}

TEST_F(Maps, GeoJsonWrong) {
    EXPECT_NE(wrong("a.geojson", "{\"type\":"), "");
    EXPECT_NE(wrong("a.geojson", "\xff\xfe{}"), "");
    EXPECT_EQ(wrong("a.geojson", "[]"),
              "a.geojson: GDAL cannot read it as GeoJSON with a FeatureCollection or a "
              "Feature");
    const auto feature = [&](const std::string& properties, const std::string& geometry) {
        return wrong("a.geojson", R"({"type":"Feature","properties":)" + properties +
                                      R"(,"geometry":)" + geometry + "}");
    };
    EXPECT_EQ(feature("null", R"({"type":"Polygon","coordinates":)"
                              R"([[[0,0],[1,0],[1,1],[0,0]]]})"),
              "a.geojson: feature 1: it needs an attribute 'type' that names a terrain "
              "type of the library");
    EXPECT_EQ(feature(R"({"type":"plain"})", R"({"type":"Polygon"})"),
              "a.geojson: Invalid Polygon object. Missing 'coordinates' member.");
    EXPECT_EQ(
        feature(R"({"type":"plain"})", R"({"type":"Polygon","coordinates":[[[0]]]})"),
        "a.geojson: feature 1: it is of type 'plain' but has no outline that can be "
        "read; draw its polygon or delete the feature");
    EXPECT_EQ(feature(R"({"type":"plain"})",
                      R"({"type":"Polygon","coordinates":[[[0,0],[1,1],[0,0]]]})"),
              "a.geojson: feature 1: a ring has fewer than four corners, the first "
              "repeated at its end included");
    EXPECT_EQ(
        feature(R"({"type":"plain"})",
                R"({"type":"Polygon","coordinates":[[[0,1e300],[1,1],[0,0],[0,1]]]})"),
        "a.geojson: feature 1: a corner lies more than 1e9 away from the origin");
    std::string deep(100000, '[');
    EXPECT_NE(wrong("a.geojson", deep), "");
}

std::string drawing(const std::string& shapes) {
    return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 10 10' width='10' "
           "height='10'>" +
           shapes + "</svg>";
}

TEST_F(Maps, DrawingsByColourOrName) {
    const auto m = map(
        "a.svg",
        drawing(
            "<rect width='10' height='10' fill='#d4d08b'/>"
            "<g fill='rgb(138, 127, 120)'><path d='M2 2 H8 V8 H2 Z M4 4 H6 V6 H4 Z'/></g>"
            "<polygon id='plain' fill='red' points='0,0 1,0 1,1'/>"
            "<path d='M0 0 L5 5' fill='none' stroke='black'/>"));
    ASSERT_EQ(m.regions.size(), 3u);
    EXPECT_EQ(m.regions[0].type, "plain");
    EXPECT_EQ(m.regions[1].type, "high hills");
    EXPECT_EQ(m.regions[1].outlines.size(), 2u);  // with a hole
    EXPECT_EQ(m.regions[2].type, "plain");
    EXPECT_EQ(m.window, (Box{0.0, 0.0, 1.0, 1.0}));
    // North is up: the page's first corner is the north-west.
    EXPECT_DOUBLE_EQ(m.regions[2].outlines[0][2][1], 0.9);
    EXPECT_NE(
        wrong("a.svg", drawing("<rect id='r' width='9' height='9' fill='#ff00ff'/>"))
            .find("r: the colour #ff00ff is no type's"),
        std::string::npos);
}

TEST_F(Maps, LibrariesHaveColoursSeamsAndTransitions) {
    EXPECT_EQ(library_.types[1].colour, (std::array<std::uint8_t, 3>{0x8a, 0x7f, 0x78}));
    EXPECT_EQ(library_.types[1].examples[0].scale, 0.5);
    EXPECT_EQ(library_.types[1].examples[0].vertical_scale, 2.0);
    EXPECT_EQ(library_.types[1].examples[0].raise, 5.0);
    EXPECT_EQ(library_.seams.at(0).smoothness, 0.2);
    EXPECT_EQ(library_.transitions.at(0).width, 300.0);
    std::filesystem::copy_file(folder_ / "profile.png", folder_ / "model.tif");
    std::ofstream(folder_ / "a.ttl")
        << "[Terrain Type: A]\n color = <0.0, 1.0, 0.5, 1.0>\n sample = \"model\"\n"
           "[Terrain Type: B]\n sample = \"model\"\n[Terrain Seam: A & B]\n smoothness = "
           "0.3\n";
    const auto ttl = load_library(folder_ / "a.ttl");
    EXPECT_EQ(ttl.types[0].colour, (std::array<std::uint8_t, 3>{0, 255, 128}));
    EXPECT_NE(ttl.types[1].colour, (std::array<std::uint8_t, 3>{}));
    EXPECT_EQ(ttl.seams.at(0).b, "B");
    EXPECT_EQ(ttl.seams[0].smoothness, 0.3);
    std::ofstream(folder_ / "a.ttl") << "[Terrain Type: A]\n color = <2, 0, 0>\n";
    EXPECT_THROW(load_library(folder_ / "a.ttl"), Error);
}

}  // namespace
}  // namespace cydonia::config
