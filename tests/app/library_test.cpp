// Terrain libraries, through the program that was built.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "field/dem.h"
#include "field/files.h"
#include "field/noise.h"
#include "field/svg.h"
#include "tests/app/program.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

struct Libraries : testing::Test {
    TemporaryFolder folder;
    Libraries() {
        for (int i = 0; i < 3; ++i) {
            write("high-" + std::to_string(i), 500.0, std::uint64_t(i));
            write("low-" + std::to_string(i), 60.0, std::uint64_t(i + 10));
        }
        folder.write("land.toml",
                     "levels = [60.0, 30.0]\n[[type]]\nname = \"<high>\"\n"
                     "examples = \"high-*.tif\"\n[[type]]\nname = \"low\"\n"
                     "examples = [\"low-0.tif\", \"low-1.tif\", \"low-2.tif\"]\n");
    }
    void write(const std::string& name, double height, std::uint64_t seed) {
        NoiseOptions noise;
        noise.octaves = 6;
        noise.h = 1.0;
        Terrain terrain;
        terrain.heights = noise_field(noise, 128, 112, height, seed);
        terrain.spacing = 30.0;
        write_geotiff(folder / (name + ".tif"), terrain);
    }
    Outcome ask(std::vector<std::string> options) const {
        options.insert(options.begin(), "library");
        return run({folder.path()}, options);
    }
    void expect_refused(const std::string& library, const std::string& reason) const {
        folder.write("land.toml", library);
        const Outcome outcome = ask({"analyse", "land.toml"});
        EXPECT_EQ(outcome.code, 2) << outcome.out;
        EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
    }
};

}  // namespace

TEST_F(Libraries, AreAnalysedAndKept) {
    const Outcome first = ask({"analyse", "land.toml"});
    ASSERT_EQ(first.code, 0) << first.err;
    EXPECT_NE(first.out.find("60 m\n"), std::string::npos) << first.out;
    EXPECT_NE(first.out.find("  low "), std::string::npos) << first.out;
    // Two levels of six models; not made again.
    const fs::path kept = folder / "out/land/.cache/analyses";
    const auto written = [&] {
        std::map<fs::path, fs::file_time_type> times;
        for (const auto& entry : fs::directory_iterator(kept))
            times[entry.path()] = fs::last_write_time(entry.path());
        return times;
    };
    const auto times = written();
    EXPECT_EQ(times.size(), 12u);
    EXPECT_EQ(ask({"analyse", "land.toml"}).out, first.out);
    EXPECT_EQ(written(), times);
    // A damaged one is made again.
    for (const auto& [file, time] : times) write_text(file, "[[1, 2");
    EXPECT_EQ(ask({"analyse", "land.toml"}).out, first.out);
    EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});
}

TEST_F(Libraries, ClassifyLand) {
    write("new", 480.0, 33);
    const Outcome outcome = ask({"classify", "land.toml", "new.tif"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("30 m: <high> ("), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("agreement"), std::string::npos);
    const Outcome compared = ask({"compare", "land.toml", "new.tif"});
    for (const char* level : {"60m", "30m"}) {
        const fs::path plot =
            folder / ("out/land/compared-" + std::string(level) + ".svg");
        const std::string text = read_text(plot);
        EXPECT_NE(text.find("new.tif"), std::string::npos);
        EXPECT_NE(text.find("&lt;high&gt;"), std::string::npos);  // any name is text
        const Field<Rgba8> picture =
            read_svg(open_source(plot), 430, 430, SvgEdges::kSmooth);
        EXPECT_TRUE(std::ranges::any_of(picture, [](const Rgba8& pixel) {
            return pixel[2] > 120 && pixel[0] < 60;  // a type's blue
        }));
    }
    EXPECT_EQ(compared.code, 0);
    EXPECT_NE(compared.out.find("edge strength"), std::string::npos) << compared.out;
}

// Section VII.5: land of two types is cut into them, and what of it is pure is told.
TEST_F(Libraries, ClassifyMixedLand) {
    Terrain both = read_dem(open_source(folder / "high-0.tif"));
    const auto made = [&](double height, std::uint64_t seed) {
        NoiseOptions noise;
        noise.octaves = 6;
        noise.h = 1.0;
        return noise_field(noise, 320, 200, height, seed);
    };
    both.heights = made(500.0, 41);
    const Field<float> low = made(60.0, 42);
    for (int y = 0; y < 200; ++y)
        for (int x = 160; x < 320; ++x) both.heights(x, y) = low(x, y);
    write_geotiff(folder / "both.tif", both);
    const Outcome mixed = ask({"classify", "land.toml", "both.tif"});
    ASSERT_EQ(mixed.code, 0) << mixed.err;
    EXPECT_NE(mixed.err.find("both.tif has several types"), std::string::npos)
        << mixed.err;
    const Field<Rgba8> map = read_rgba(open_source(folder / "out/land/both-types.png"));
    EXPECT_EQ(map.width(), 320);
    // The first type is blue, the second vermilion.
    int right = 0;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 320; ++x) right += (map(x, y)[2] > map(x, y)[0]) == (x < 160);
    EXPECT_GT(right, 0.9 * 320 * 200);
    // Both windows make a library whose types agree.
    const std::size_t begin = mixed.out.find("    # <high>\n"),
                      next = mixed.out.find("    # low\n");
    ASSERT_NE(begin, std::string::npos) << mixed.out;
    ASSERT_NE(next, std::string::npos) << mixed.out;
    const auto line = [&](std::size_t at) {
        const std::size_t from = mixed.out.find('\n', at) + 1;
        return mixed.out.substr(from, mixed.out.find('\n', from) - from);
    };
    folder.write("pure.toml",
                 "levels = [30.0]\n[[type]]\nname = \"high\"\nexample = [\n" +
                     line(begin) + "\n]\n[[type]]\nname = \"low\"\nexample = [\n" +
                     line(next) + "\n]\n");
    const Outcome pure = ask({"classify", "pure.toml", "high-0.tif"});
    EXPECT_EQ(pure.code, 0) << pure.err;
    EXPECT_NE(pure.out.find("30 m: high ("), std::string::npos) << pure.out;
    EXPECT_NE(pure.err.find("'high' has one example"), std::string::npos) << pure.err;
    // Land of one type is not called mixed.
    write("new", 480.0, 33);
    const Outcome one = ask({"classify", "land.toml", "new.tif"});
    EXPECT_EQ(one.err.find("several types"), std::string::npos) << one.err;
    EXPECT_NE(one.out.find("types at 30 m"), std::string::npos) << one.out;
}

// What is no land says nothing of it, and that is told, the second time too.
TEST_F(Libraries, LeaveOutWaterAndVoids) {
    const Terrain whole = read_dem(open_source(folder / "high-1.tif"));
    Terrain lake = whole, holes = whole, sea = whole;
    for (int y = 0; y < 112; ++y)
        for (int x = 0; x < 128; ++x) {
            if (x < 32) lake.heights(x, y) = 1.0f;
            if (x < 4) holes.heights(x, y) = std::nanf("");
            if (x < 110) sea.heights(x, y) = 0.0f;
        }
    write_geotiff(folder / "lake.tif", lake);
    write_geotiff(folder / "holes.tif", holes);
    write_geotiff(folder / "sea.tif", sea);
    folder.write(
        "land.toml",
        "levels = [30.0]\n[[type]]\nname = \"high\"\nexamples = [\"high-*.tif\", "
        "\"lake.tif\", \"holes.tif\"]\n[[type]]\nname = \"low\"\n"
        "examples = \"low-*.tif\"\n[[type]]\nname = \"wet\"\nexamples = "
        "\"sea.tif\"\n[[type]]\nname = \"bare\"\n");
    for (int time = 0; time < 2; ++time) {
        const Outcome outcome = ask({"analyse", "land.toml"});
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        for (const char* said :
             {"lake.tif: left out 25.0% under water",
              "holes.tif: left out 26.6% that is at most 30 samples from a void",
              "sea.tif: of it 85.9% under water, so that too little land is left",
              "'wet' has no example", "'bare' has no examples, so no land is similar"})
            EXPECT_NE(outcome.err.find(said), std::string::npos) << said << outcome.err;
        // Their other three quarters are what the whole is.
        EXPECT_NE(outcome.out.find("high             5  0.9"), std::string::npos)
            << outcome.out;
    }
    const Outcome classified = ask({"classify", "land.toml", "lake.tif"});
    ASSERT_EQ(classified.code, 0) << classified.err;
    const Field<Rgba8> map = read_rgba(open_source(folder / "out/land/lake-types.png"));
    EXPECT_EQ(map(10, 50), (Rgba8{24, 44, 84, 255}));
    EXPECT_NE(map(40, 50), (Rgba8{24, 44, 84, 255}));
    EXPECT_NE(classified.out.find("100.0%"), std::string::npos) << classified.out;
    const Outcome none = ask({"classify", "land.toml", "sea.tif"});
    EXPECT_EQ(none.code, 2);
    EXPECT_NE(none.err.find("too little land is left"), std::string::npos) << none.err;
}

// Any number of types of any name.
TEST_F(Libraries, PrintNarrowTables) {
    std::string library = "levels = [30.0]\n";
    for (int t = 0; t < 12; ++t)
        library += "[[type]]\nname = \"a very long name of a type of land that goes on " +
                   std::to_string(t) + "\"\nexamples = \"" + (t % 2 ? "high-" : "low-") +
                   std::to_string(t % 3) + ".tif\"\n";
    folder.write("land.toml", library);
    for (const Outcome& outcome :
         {ask({"analyse", "land.toml"}), ask({"compare", "land.toml", "high-0.tif"})}) {
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        std::istringstream lines(outcome.out);
        for (std::string line; std::getline(lines, line);)
            EXPECT_LE(line.size(), 80u) << line;
    }
}

// Saunders 2006, figure V.5.
TEST_F(Libraries, AreReadFromTheThesisForm) {
    const std::string types =
        "# A Terrain Type entry\n[Terrain Type: High_Land]\n"
        "    color = <0.6, 0.6, 0.3, 1.0>\n    sample = \"high-0\"   # by its name\n"
        "    sample = \"high-1\"\n\n[Terrain Type: Low_Land]\n    sample = \"low-0\"\n"
        "    sample = \"low-1.tif\"\n[Terrain Seam: High_Land & Low_Land]\n"
        "    smoothness = 0.3\n[Aggregate: LOD_30m]\n"
        "    elevation_mean_variance      = 8.18938e+008f\n";
    folder.write("land.ttl", types);
    const Outcome outcome = ask({"analyse", "land.ttl"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("30 m\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("High_Land"), std::string::npos);
    for (const auto& [text, reason] :
         {std::pair{"[Terrain Type: A]\nsample = \"gone\"\n", "land.ttl:2: no elevation"},
          std::pair{"[Terrain Type: A]\nsample = \"../land\"\n",
                    "land.ttl:2: no elevation"},
          std::pair{"[Terrain Type: A]\nsample = high-0\n", "in quotes"},
          std::pair{"[Terrain Type: A\n", "ends with ]"},
          std::pair{"[Terrain Type: A]\n[Terrain Type: A]\n", "two terrain types 'A'"},
          std::pair{"[Terrain Type: A]\n\x01\x02\xff\n", "land.ttl:2: expected"},
          std::pair{"# nothing\n", "no section [Terrain Type"}}) {
        folder.write("land.ttl", text);
        const Outcome refused = ask({"analyse", "land.ttl"});
        EXPECT_EQ(refused.code, 2);
        EXPECT_NE(refused.err.find(reason), std::string::npos) << refused.err;
    }
}

TEST_F(Libraries, ThatSayNothingAreRefused) {
    expect_refused("levels = [30.0]\n", "no types");
    expect_refused("[[type]]\nname = \"a\"\n[[type]]\nname = \"a\"\n", "a");
    expect_refused("levels = [30.0, 60.0]\n[[type]]\nname = \"a\"\n", "coarse to fine");
    expect_refused("[[type]]\nname = \"a\"\nexamples = \"none.tif\"\n", "none.tif");
    expect_refused(
        "[[type]]\nname = \"a\"\nexample = [{ source = \"high-0.tif\", window = "
        "[0.5, 0.0, 0.5, 1.0] }]\n",
        "west, south, east and north");
    expect_refused("[[type]]\nname = \"a\"\nkolour = 1\n", "unknown key");
    // Types without any example, and examples too coarse for every level.
    expect_refused("[[type]]\nname = \"a\"\n", "no example");
    expect_refused("levels = [10.0]\n[[type]]\nname = \"a\"\nexamples = \"high-0.tif\"\n",
                   "fine and large enough");
    folder.write("bad.tif", "not a model");
    expect_refused("levels = [30.0]\n[[type]]\nname = \"a\"\nexamples = \"bad.tif\"\n",
                   "bad.tif");
}
