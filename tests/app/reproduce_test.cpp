// Everything of a manifest made again and compared, through the program that was built.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "field/files.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"
#include "tests/schema/validator.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

using Json = nlohmann::json;

// A little land, its manifest in out/.
struct Reproduce : testing::Test {
    TemporaryFolder folder;
    Reproduce() {
        folder.write("land.toml", kSmallScene);
        run({folder.path()},
            {"export", "land.toml", "-o", "out", "--to", "raw16", "--quiet"});
    }

    Json manifest() const { return Json::parse(read_text(folder / "out/manifest.json")); }
    void write(const Json& manifest) const {
        folder.write("out/manifest.json", manifest.dump());
    }
    Outcome again(std::vector<std::string> options = {"-o", "again"}) const {
        options.insert(options.begin(), {"reproduce", "out/manifest.json"});
        return run({folder.path()}, options);
    }
    void expect_refused(const std::string& reason) const {
        const Outcome outcome = again();
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
        EXPECT_FALSE(fs::exists(folder / "again")) << "refused before any work";
    }
    void expect_refused_with(const char* path, const Json& value,
                             const std::string& reason) const {
        const Json whole = manifest();
        Json changed = whole;
        changed[Json::json_pointer(path)] = value;
        write(changed);
        expect_refused(reason);
        write(whole);
    }
};

}  // namespace

TEST_F(Reproduce, TheManifestIsAsItsSchemaSays) {
    const Validator schema(Json::parse(
        read_text(fs::path(CYDONIA_SOURCE_DIR) / "config/schema/manifest.schema.json")));
    EXPECT_EQ(schema.complaint(manifest()), "");
    Json wrong = manifest();
    wrong["outputs"][0]["xxh3"] = "short";
    EXPECT_NE(schema.complaint(wrong), "");
    wrong = manifest();
    wrong["more"] = 1;
    EXPECT_NE(schema.complaint(wrong), "");
}

TEST_F(Reproduce, EverythingIsEqual) {
    const Outcome outcome = again();
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const Json& output : manifest().at("outputs")) {
        const std::string file = output.at("file");
        EXPECT_NE(outcome.out.find("  " + file + " "), std::string::npos) << outcome.out;
        EXPECT_EQ(read_text(folder / "out/" += file),
                  read_text(folder / "again/" += file));
    }
    EXPECT_NE(outcome.out.find("5 files: 5 equal"), std::string::npos) << outcome.out;
}

// The first files may be gone, and both folders may have moved together.
TEST_F(Reproduce, TheManifestAloneIsEnough) {
    fs::create_directories(folder / "elsewhere");
    fs::copy(folder / "out/manifest.json", folder / "elsewhere/manifest.json");
    fs::remove_all(folder / "out");
    const Outcome outcome =
        run({folder.path()}, {"reproduce", "elsewhere/manifest.json", "--quiet"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(files_below(folder / "elsewhere"),
              std::vector<std::string>{"manifest.json"});
}

TEST_F(Reproduce, WhatDiffersIsNamedWithExitThree) {
    Json changed = manifest();
    for (Json& output : changed["outputs"])
        if (output.at("file") == "terrain.exr") output["xxh3"] = "0123456789abcdef";
    write(changed);
    const Outcome outcome = again();
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_NE(outcome.out.find("terrain.exr           DIFFERENT"), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("1 DIFFERENT, 4 equal"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.err.find("1 of 5 files"), std::string::npos) << outcome.err;
}

TEST_F(Reproduce, WhatIsNotMadeAgainIsMissing) {
    Json changed = manifest();
    changed["outputs"].push_back({{"file", "masks/none.png"},
                                  {"step", "terrain"},
                                  {"bytes", 1},
                                  {"xxh3", "0123456789abcdef"}});
    write(changed);
    const Outcome outcome = again();
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_NE(outcome.out.find("MISSING"), std::string::npos) << outcome.out;
}

TEST_F(Reproduce, ChangedInputsAreNamed) {
    folder.write("land.toml", kSmallScene + "# another\n");
    expect_refused("land.toml has changed since: xxh3 ");
    fs::remove(folder / "land.toml");
    expect_refused("land.toml");
}

TEST_F(Reproduce, OptionsThatReadOtherwiseAreNamed) {
    Json changed = manifest();
    std::string text = changed["options"]["stages"][0]["text"];
    text.replace(text.find("blending_bias = 3"), 17, "blending_bias = 5");
    changed["options"]["stages"][0]["text"] = text;
    write(changed);
    expect_refused("terrain.stage[0]: blending_bias = 3 was different then");
}

TEST_F(Reproduce, AnotherBuildIsSaid) {
    Json changed = manifest();
    changed["versions"]["program"] = "0123456789abcdef";
    write(changed);
    const Outcome outcome = again();
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("another build"), std::string::npos) << outcome.err;
}

TEST_F(Reproduce, BadInput) {
    expect_refused_with("/manifest", 2, "a manifest of version 2; this cydonia");
    expect_refused_with("/outputs/0/file", "../../etc/passwd", "leaves the manifest's");
    expect_refused_with("/outputs/0/file", "/etc/passwd", "leaves the manifest's folder");
    expect_refused_with("/timings/threads", 100000, "threads: 100000");
    expect_refused_with("/command/quality", "best", "'best' is not known");
    expect_refused_with("/command/goals/0", "all", "'all' is not known");
    expect_refused_with("/command/export/to", "step", "'step' is not known");
    expect_refused_with("/command/export/samples", 0, "samples: 0");
    expect_refused_with("/command/size", Json::array({0, 1000000}), "size: 0");
    expect_refused_with("/command/goals", Json::array(), "nothing was finished");
    expect_refused_with("/outputs", 7, "not a manifest of Cydonia");
    for (const char* text : {"", "{", "[]", "{}", "7", "\"text\"", "{\"manifest\": 1}"}) {
        folder.write("out/manifest.json", text);
        expect_refused("not a manifest of Cydonia");
    }
    fs::remove(folder / "out/manifest.json");
    expect_refused("no such file");
}

TEST_F(Reproduce, NotOverTheFirstFiles) {
    const Outcome outcome = again({"-o", "out"});
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("the manifest's own folder"), std::string::npos)
        << outcome.err;
}
