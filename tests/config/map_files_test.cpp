// Maps of terrain types in the formats that are text.
#include "config/reader/map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "config/reader/library.h"
#include "field/random.h"
#include "tests/field/temporary_folder.h"

namespace cydonia::config {
namespace {

using genetic::LibraryOptions;
using genetic::MapOptions;
using genetic::Outline;

struct MapFile : testing::Test {
    TemporaryFolder folder;
    LibraryOptions library;
    MapFile() {
        library.types = {{.name = "plain", .examples = {}, .colour = {120, 156, 84}},
                         {.name = "high hills", .examples = {}, .colour = {200, 40, 30}}};
    }
    MapOptions load(const std::string& name, const std::string& text) const {
        return load_map(folder.with(name, text), library);
    }
    void expect_refused(const std::string& name, const std::string& text,
                        std::string_view words) const {
        expect_error(ExitCode::kBadRequest, words, [&] { load(name, text); });
    }
};

const Outline kTriangle = {{0.0, 0.0}, {10.0, 0.0}, {0.0, 5.0}};

TEST_F(MapFile, Toml) {
    const MapOptions map =
        load("m.toml",
             "window = [1.0, 2.0, 8.0, 4.0]\nsmoothness = 0.25\n[[region]]\n"
             "type = \"plain\"\nname = \"low\"\noutline = [[0, 0], [10, 0], [0.0, 5.0]]\n"
             "[[region]]\ntype = \"high_hills\"\noutline = [[0, 0], [10, 0], [0, 5]]\n");
    ASSERT_EQ(map.regions.size(), 2u);
    EXPECT_EQ(map.regions[0].name, "low");
    EXPECT_EQ(map.regions[0].type, "plain");
    EXPECT_EQ(map.regions[0].outlines.at(0), kTriangle);
    EXPECT_EQ(map.regions[1].type, "high hills");  // with a space in the library
    EXPECT_EQ(map.window, (std::array{1.0, 2.0, 8.0, 4.0}));
    EXPECT_EQ(map.smoothness, 0.25);
}

TEST_F(MapFile, WithoutAWindowAllThatIsDrawn) {
    const MapOptions map = load("m.toml",
                                "[[region]]\ntype = \"plain\"\n"
                                "outline = [[-3, 1], [7, 1], [0, 5]]\n[[region]]\n"
                                "type = \"plain\"\noutline = [[0, 0], [9, 1], [0, 5]]\n");
    EXPECT_EQ(map.window, (std::array{-3.0, 0.0, 9.0, 5.0}));
}

TEST_F(MapFile, BadToml) {
    const std::string outline = "outline = [[0, 0], [10, 0], [0, 5]]\n";
    const auto refused = [&](const std::string& text, std::string_view words) {
        expect_refused("m.toml", text, words);
    };
    refused("",
            "m.toml: it has no regions; give at least one outline with a terrain type");
    refused("[[region]]\n" + outline, "m.toml:1:1: region[0]: missing key 'type'");
    refused("[[region]]\ntype = \"plain\"\n", "region[0]: missing key 'outline'");
    refused("[[region]]\ntype = \"plain\"\noutline = [[0, 0], [1, 1]]\n",
            "m.toml:3:11: region[0].outline: needs 3 to");
    refused("[[region]]\ntype = \"plain\"\noutline = [[0, 0], [1], [2, 3]]\n",
            "m.toml:3:");
    refused("[[region]]\ntype = \"plain\"\noutline = [[0, 0], [inf, 1], [2, 3]]\n",
            "m.toml:3:");
    refused("[[region]]\ntipe = \"plain\"\ntype = \"plain\"\n" + outline,
            "did you mean 'type'?");
    refused("smoothness = 2\n[[region]]\ntype = \"plain\"\n" + outline, "m.toml:1:");
    refused("window = [3, 0, 1, 1]\n[[region]]\ntype = \"plain\"\n" + outline,
            "its window must be west, south, east and north");
    refused("[[region]\n", "m.toml:1:");
}

TEST_F(MapFile, GeoJson) {
    const std::string ring = "[[0,0],[10,0],[0,5],[0,0]]";
    const MapOptions map = load("m.geojson",
                                R"({"type":"FeatureCollection","features":[
           {"type":"Feature","properties":{"type":"plain","name":"low"},
            "geometry":{"type":"Polygon","coordinates":[)" +
                                    ring + R"(,[[1,1],[2,1],[1,2],[1,1]]]}},
           {"type":"Feature","properties":{"name":"a road"},
            "geometry":{"type":"LineString","coordinates":[[0,0],[1,1]]}},
           {"type":"Feature","properties":null,"geometry":null},
           {"type":"Feature","properties":{"terrain":"high hills"},
            "geometry":{"type":"MultiPolygon","coordinates":[[)" +
                                    ring + "],[" + ring + "]]}}]}");
    ASSERT_EQ(map.regions.size(), 2u);
    EXPECT_EQ(map.regions[0].name, "low");
    ASSERT_EQ(map.regions[0].outlines.size(), 2u);
    EXPECT_EQ(map.regions[0].outlines[0], kTriangle);  // without the first again
    EXPECT_EQ(map.regions[1].type, "high hills");
    EXPECT_EQ(map.regions[1].outlines.size(), 2u);
    EXPECT_EQ(map.window, (std::array{0.0, 0.0, 10.0, 5.0}));
}

TEST_F(MapFile, BadGeoJson) {
    const auto refused = [&](const std::string& text, std::string_view words) {
        expect_refused("m.geojson", text, words);
    };
    const auto feature = [](const std::string& properties, const std::string& geometry) {
        return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":)" +
               geometry + "}";
    };
    const auto polygon = [&](const std::string& rings) {
        return feature(R"({"type":"plain"})",
                       R"({"type":"Polygon","coordinates":)" + rings + "}");
    };
    refused("{\n\"type\": \n]", "m.geojson: GDAL cannot read it as GeoJSON");
    refused("[]", "with a FeatureCollection or a Feature");
    refused("3", "with a FeatureCollection or a Feature");
    refused("{\"type\":\"FeatureCollection\",\"features\":[\n]", "line 2, character");
    refused(R"({"type":"FeatureCollection"})", "Missing 'features' member");
    refused(R"({"type":"FeatureCollection","features":[]})",
            "it has no regions; give at least one outline with a terrain type");
    refused(R"({"type":"FeatureCollection","features":[7]})",
            "it has no regions; give at least one outline with a terrain type");
    refused(
        feature("{}", R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]})"),
        "feature 1: it needs an attribute 'type'");
    refused(polygon("7"), "feature 1: it is of type 'plain' but has no outline");
    refused(polygon("[]"), "feature 1: it is of type 'plain' but has no outline");
    refused(polygon("[7]"), "feature 1: it is of type 'plain' but has no outline");
    refused(polygon("[[7]]"), "feature 1: it is of type 'plain' but has no outline");
    refused(polygon(R"([[[0,0],["a",0],[0,5],[0,0]]])"), "Invalid 'x' coordinate");
    refused(polygon(R"([[[0,0],[4,0],[0,4],[0,0]],[[0,0],["a",0],[0,5],[0,0]]])"),
            "Invalid 'x' coordinate");
    refused(polygon("[[[0,0],[1e300,0],[0,5],[0,0]]]"), "more than 1e9 away");
    refused(polygon("[[[0,0],[1,0],[0,0]]]"), "fewer than four corners");
    refused(polygon("[[[0,0],[1,0],[1,1],[0,1]]]"), "does not end where it begins");
    refused(feature(R"({"type":"pl\nain"})",
                    R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]})"),
            "needs an attribute 'type'");
    refused(std::string(200000, '['), "m.geojson: ");
}

// Figure V.10.
TEST_F(MapFile, ThesisForm) {
    const MapOptions map = load("m.map",
                                "# Map vertices\nv 0.0 0.0      # 1\nv 10.0 0\n"
                                "v 0 5\r\n\ntt high_hills\nf 1 2 3\ntt plain\n"
                                "f -3 -2 -1\nf 3 2 1\n");
    ASSERT_EQ(map.regions.size(), 3u);
    EXPECT_EQ(map.regions[0].type, "high hills");
    EXPECT_EQ(map.regions[1].type, "plain");
    EXPECT_EQ(map.regions[0].outlines[0], kTriangle);
    EXPECT_EQ(map.regions[1].outlines[0], kTriangle);
    EXPECT_EQ(map.regions[2].outlines[0], (Outline{{0, 5}, {10, 0}, {0, 0}}));
    EXPECT_NE(map.regions[1].name, map.regions[2].name);
}

TEST_F(MapFile, BadThesisForm) {
    const auto refused = [&](const std::string& text, std::string_view words) {
        expect_refused("m.map", text, words);
    };
    const std::string corners = "v 0 0\nv 10 0\nv 0 5\n";
    refused("v 0\n", "m.map:1: a corner is 'v EAST NORTH'");
    refused("v 0 nan\n", "m.map:1: a corner");
    refused("v 1e300 0\n", "m.map:1: a corner");
    refused(corners + "f 1 2 3\n", "m.map:4: a face needs a terrain type");
    refused(corners + "tt\n", "m.map:4: a terrain type is 'tt NAME'");
    refused(corners + "tt plain\nf 1 2\n", "m.map:5: a face has at least three");
    refused(corners + "tt plain\nf 1 2 4\n", "m.map:5: there is no corner '4'");
    refused(corners + "tt plain\nf 1 2 0\n", "m.map:5: there is no corner '0'");
    refused(corners + "tt plain\nf 1 2 -4\n", "m.map:5: there is no corner '-4'");
    refused(corners + "tt plain\nf 1 2 3x\n", "m.map:5: there is no corner '3x'");
    refused(corners + "tt plain\nf 1 2 -9223372036854775808\n", "m.map:5: there is no");
    refused(corners + "usemtl plain\n", "m.map:4: unknown record 'usemtl'");
    refused(corners, "it has no regions; give at least one outline with a terrain type");
}

std::string drawing(const std::string& shapes) {
    return R"(<svg xmlns="http://www.w3.org/2000/svg" )"
           R"(xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" )"
           R"(width="100" height="50" viewBox="0 0 100 50">)" +
           shapes + "</svg>";
}

TEST_F(MapFile, Svg) {
    const MapOptions map = load(
        "m.svg",
        drawing(R"(<rect x="0" y="0" width="100" height="50" fill="#789c54"/>)"
                R"(<path style="stroke:none; fill: #c8281e" d="M 10 10 H 30 V 20 H 10 Z)"
                R"( M 12 12 H 14 V 14 H 12 Z"/>)"
                R"(<polygon id="high_hills" fill="#0000ff" points="50,10 60,10 60,20"/>)"
                R"x(<g fill="rgb(120, 156, 84)"><circle cx="80" cy="25" r="10"/></g>)x"
                R"(<path fill="none" stroke="black" d="M 0 0 L 100 50"/>)"));
    ASSERT_EQ(map.regions.size(), 4u);
    EXPECT_EQ(map.window, (std::array{0.0, 0.0, 1.0, 1.0}));
    EXPECT_EQ(map.regions[0].type, "plain");
    EXPECT_EQ(map.regions[1].type, "high hills");
    EXPECT_EQ(map.regions[1].outlines.size(), 2u);  // its hole
    EXPECT_EQ(map.regions[2].type, "high hills");   // as it is called
    EXPECT_EQ(map.regions[3].type, "plain");        // of its group
    const auto& [x, y] = map.regions[1].outlines[0][0];
    EXPECT_NEAR(x, 0.1, 1e-12);  // north is up
    EXPECT_NEAR(y, 0.8, 1e-12);
}

// A path without a Z is filled as if it had one.
TEST_F(MapFile, OpenSvgPathsAreClosed) {
    const MapOptions map =
        load("m.svg", drawing(R"(<path fill="#c8281e" d="M 10 10 H 30 V 20"/>)"));
    ASSERT_EQ(map.regions.size(), 1u);
    EXPECT_EQ(map.regions[0].outlines[0].size(), 3u);
}

// Fills with the colour names of CSS.
TEST_F(MapFile, SvgColoursByName) {
    library.types[0].colour = {0, 128, 0};
    const MapOptions map = load(
        "m.svg", drawing(R"(<rect x="0" y="0" width="9" height="9" fill="green"/>)"));
    EXPECT_EQ(map.regions.at(0).type, "plain");
}

TEST_F(MapFile, BadSvg) {
    expect_refused("m.svg", "<svg", "m.svg");
    expect_refused("m.svg", drawing(""),
                   "it has no regions; give at least one outline with a terrain type");
    expect_refused("m.svg",
                   drawing(R"(<rect id="pond" width="9" height="9" fill="#0000ff"/>)"),
                   "pond: the colour #0000ff is no type's");
    expect_refused("m.svg", drawing(R"(<path fill="#789c54" d="M 0 0 L x"/>)"), "m.svg");
}

TEST_F(MapFile, OtherFiles) {
    expect_refused("m.png", "x",
                   "a map is a .toml, .svg, .geojson, .shp, .gpkg or .map file");
    EXPECT_THROW(load_map(folder / "none.map", library), Error);
    EXPECT_EQ(load("M.MAP", "v 0 0\nv 1 0\nv 0 1\ntt plain\nf 1 2 3\n").regions.size(),
              1u);
}

TEST_F(MapFile, SizesAreBounded) {
    std::string text = "v 0 0\nv 1 0\nv 0 1\ntt plain\n";
    for (int i = 0; i < 4097; ++i) text += "f 1 2 3\n";
    expect_refused("m.map", text, "more than 4096 regions");
    std::string corners;
    for (int i = 0; i <= 1'000'000; ++i) corners += "v 1 2\n";
    expect_refused("m.map", corners, "m.map:1000001: more than 1000000 corners");
    EXPECT_THROW(load("m.map", std::string((16u << 20) + 1, '#')), Error);
}

// Good files with some bytes changed give a map or our own message.
TEST_F(MapFile, SpoiltFilesEndInAMapOrAMessage) {
    const std::vector<std::pair<std::string, std::string>> good = {
        {"m.toml",
         "window = [0, 0, 8, 4]\n[[region]]\ntype = \"plain\"\n"
         "outline = [[0, 0], [10, 0], [0.0, 5.0]]\n"},
        {"m.geojson",
         R"({"type":"Feature","properties":{"type":"plain"},"geometry":)"
         R"({"type":"Polygon","coordinates":[[[0,0],[10,0],[0,5],[0,0]]]}})"},
        {"m.map", "v 0 0\nv 10 0\nv 0 5\ntt plain\nf 1 -2 3\n"},
        {"m.svg", drawing(R"(<path fill="#789c54" d="M 0 0 H 9 V 9 Z"/>)")}};
    for (const auto& [name, text] : good) {
        EXPECT_TRUE(survives([&] { load(name, text); }));
        for (std::uint64_t seed = 0; seed < 400; ++seed) {
            std::string spoilt = text;
            for (std::uint64_t i = 0; i <= seed % 4; ++i) {
                const std::uint64_t h = hash_of({seed, i});
                const std::size_t at = h % spoilt.size();
                if (h >> 60 < 4)
                    spoilt.resize(at + 1);
                else if (h >> 60 < 8)
                    spoilt.insert(at, spoilt.substr(mix(h) % spoilt.size(), 20));
                else
                    spoilt[at] =
                        h >> 60 < 12 ? char(mix(h)) : "0-9[]{},.\"e"[mix(h) % 11];
            }
            survives([&] { load(name, spoilt); });
        }
    }
}

struct SeamFile : testing::Test {
    TemporaryFolder folder;
    LibraryOptions load(const std::string& name, const std::string& text) const {
        return load_library(folder.with(name, text));
    }
    void expect_refused(const std::string& name, const std::string& text,
                        std::string_view words) const {
        expect_error(ExitCode::kBadRequest, words, [&] { load(name, text); });
    }
};

const std::string kTypes =
    "[[type]]\nname = \"plain\"\ncolour = \"#102030\"\n[[type]]\nname = \"hills\"\n"
    "[[type]]\nname = \"peaks\"\n";

TEST_F(SeamFile, Toml) {
    const LibraryOptions library = load(
        "l.toml", kTypes +
                      "[[seam]]\nbetween = [\"plain\", \"hills\"]\nsmoothness = 0.3\n"
                      "[[transition]]\nbetween = [\"plain\", \"peaks\"]\n"
                      "type = \"hills\"\nwidth = 1500.0\n");
    ASSERT_EQ(library.seams.size(), 1u);
    EXPECT_EQ(library.seams[0].a, "plain");
    EXPECT_EQ(library.seams[0].b, "hills");
    EXPECT_EQ(library.seams[0].smoothness, 0.3);
    ASSERT_EQ(library.transitions.size(), 1u);
    EXPECT_EQ(library.transitions[0].type, "hills");
    EXPECT_EQ(library.transitions[0].width, 1500.0);
    EXPECT_EQ(library.types[0].colour, (std::array<std::uint8_t, 3>{16, 32, 48}));
}

// Types without a colour get different ones.
TEST_F(SeamFile, ColoursDiffer) {
    std::string text;
    for (int i = 0; i < 64; ++i)
        text += "[[type]]\nname = \"t" + std::to_string(i) + "\"\n";
    const LibraryOptions library = load("l.toml", text);
    std::set<std::array<std::uint8_t, 3>> colours;
    for (const auto& type : library.types) colours.insert(type.colour);
    EXPECT_EQ(colours.size(), 64u);
    EXPECT_FALSE(colours.contains({0, 0, 0}));
}

TEST_F(SeamFile, BadToml) {
    const auto refused = [&](const std::string& text, std::string_view words) {
        expect_refused("l.toml", kTypes + text, words);
    };
    refused("[[seam]]\nbetween = [\"plain\"]\nsmoothness = 0.3\n",
            "must name two different types");
    refused("[[seam]]\nbetween = [\"plain\", \"plain\"]\nsmoothness = 0.3\n",
            "must name two different types");
    refused("[[seam]]\nbetween = [\"plain\", \"hils\"]\nsmoothness = 0.3\n",
            "did you mean 'hills'?");
    refused("[[seam]]\nbetween = [\"plain\", \"hills\"]\nsmoothness = 1.3\n",
            "seam[0].smoothness");
    refused("[[transition]]\nbetween = [\"plain\", \"hills\"]\ntype = \"peeks\"\n",
            "did you mean 'peaks'?");
    refused("[[type]]\nname = \"a\"\ncolour = \"#102030\"\n",
            "'plain' has this colour already");
    refused("[[type]]\nname = \"a\"\ncolour = \"black\"\n", "choose another colour");
}

TEST_F(SeamFile, ThesisForm) {
    const LibraryOptions library = load(
        "l.ttl",
        "[Terrain Type: Small]\n color = <0.6, 0.6, 0.2, 1.0>\n[Terrain Type: Large]\n"
        "[Terrain Seam: Small & Large]\n    smoothness = 0.3\n");
    ASSERT_EQ(library.seams.size(), 1u);
    EXPECT_EQ(library.seams[0].a, "Small");
    EXPECT_EQ(library.seams[0].b, "Large");
    EXPECT_EQ(library.seams[0].smoothness, 0.3);
    EXPECT_EQ(library.types[0].colour, (std::array<std::uint8_t, 3>{153, 153, 51}));
    EXPECT_NE(library.types[1].colour, library.types[0].colour);
}

TEST_F(SeamFile, BadThesisForm) {
    const std::string types = "[Terrain Type: A]\n[Terrain Type: B]\n";
    const auto refused = [&](const std::string& text, std::string_view words) {
        expect_refused("l.ttl", types + text, words);
    };
    refused("[Terrain Seam: A]\n", "l.ttl:3: a terrain seam is");
    refused("[Terrain Seam: A & B]\nsmoothness = 3\n", "l.ttl:4: smoothness goes");
    refused("[Terrain Seam: A & B]\nsmoothness = rough\n", "l.ttl:4: smoothness goes");
    refused("[Terrain Seam: A & Beta]\nsmoothness = 0.3\n",
            "l.ttl:3: no terrain type 'Beta'");
    refused("[Terrain Seam: A & A]\nsmoothness = 0.3\n", "l.ttl:3:");
    refused("[Terrain Type: C]\ncolor = <2, 0, 0, 1>\n", "l.ttl:4: a color is");
    refused("[Terrain Type: C]\ncolor = red\n", "l.ttl:4: a color is");
}

}  // namespace
}  // namespace cydonia::config
