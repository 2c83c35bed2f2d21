// Terrain libraries, through the program that was built.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

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
          std::pair{"# nothing\n", "no [Terrain Type"}}) {
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
