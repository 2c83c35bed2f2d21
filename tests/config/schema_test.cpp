// The JSON Schema that the readers make, compared with every scene that ships.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "config/reader/overrides.h"
#include "config/reader/parse.h"
#include "config/reader/scene.h"
#include "field/files.h"
#include "tests/schema/validator.h"

namespace cydonia::config {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// A document as an editor passes it to a schema.
Json json_of(const Value& value) {
    const auto plain = [](const auto& data) -> Json {
        using Data = std::remove_cvref_t<decltype(data)>;
        Json json;
        if constexpr (std::is_same_v<Data, Value::Table>) {
            json = Json::object();
            for (const auto& entry : data) json[entry.key] = json_of(entry.value);
        } else if constexpr (std::is_same_v<Data, Value::Array>) {
            json = Json::array();
            for (const Value& element : data) json.push_back(json_of(element));
        } else if constexpr (std::is_same_v<Data, Value::Moment>) {
            json = data.date;
        } else {
            json = data;
        }
        return json;
    };
    return std::visit(plain, value.data);
}

Json scene_in(const fs::path& file) {
    return json_of(parse(read_text(file), file.string()));
}

const test::Validator& validator() {
    static const test::Validator validator(Json::parse(scene_schema()));
    return validator;
}

Json full() {
    return scene_in(fs::path(CYDONIA_SOURCE_DIR) / "tests/golden/config/full.toml");
}

// The document with one value inserted at a path such as "/render/camera/0/kind".
std::string complaint_with(const std::string& path, const Json& value) {
    Json scene = full();
    scene[Json::json_pointer(path)] = value;
    return validator().complaint(scene);
}

}  // namespace

TEST(Schema, EverySceneThatShipsIsValid) {
    int count = 0;
    for (const auto& entry :
         fs::directory_iterator(fs::path(CYDONIA_SOURCE_DIR) / "scenes")) {
        const fs::path file = entry.path() / "scene.toml";
        if (!fs::exists(file)) continue;
        EXPECT_EQ(validator().complaint(scene_in(file)), "") << file;
        ++count;
    }
    EXPECT_GT(count, 20);
}

// The scene that uses every key finds all of them in the schema.
TEST(Schema, EveryKeyIsThere) { EXPECT_EQ(validator().complaint(full()), ""); }

TEST(Schema, UnknownKeysAreRefusedEverywhere) {
    for (const char* table :
         {"", "/terrain", "/terrain/stage/0", "/terrain/stage/0/group/0",
          "/terrain/stage/1", "/terrain/stage/1/image/0", "/render", "/render/camera/0",
          "/render/sky", "/frames"})
        EXPECT_NE(complaint_with(std::string(table) + "/colourr", 1), "") << table;
}

TEST(Schema, WrongKindsAreRefused) {
    EXPECT_NE(complaint_with("/seed", "seven"), "");
    EXPECT_NE(complaint_with("/seed", 1.5), "");
    EXPECT_NE(complaint_with("/title", 7), "");
    EXPECT_NE(complaint_with("/terrain/extent", 5120.0), "");
    EXPECT_NE(complaint_with("/terrain/extent", Json::array({1.0, 2.0, 3.0})), "");
    EXPECT_NE(complaint_with("/terrain/stage", Json::object()), "");
    EXPECT_NE(complaint_with("/terrain/stage/0/grain", "wide"), "");
    EXPECT_NE(complaint_with("/terrain/stage/0/method", "distances"), "");
    EXPECT_NE(complaint_with("/render/camera/0/kind", "overheadd"), "");
    EXPECT_NE(complaint_with("/render/camera/0/name", "a/b"), "");
    EXPECT_NE(complaint_with("/render/sky", 1), "");
}

TEST(Schema, ValuesOutOfRangeAreRefused) {
    EXPECT_NE(complaint_with("/seed", -1), "");
    EXPECT_NE(complaint_with("/terrain/samples", 1), "");
    EXPECT_NE(complaint_with("/terrain/extent", Json::array({0.0, 10.0})), "");
    EXPECT_NE(complaint_with("/render/sky/turbidity", 1.0), "");
    EXPECT_NE(complaint_with("/render/camera/0/size", Json::array({8, 8})), "");
    // A key over time as well as a plain value.
    const auto keys = [](double value) {
        return Json{{"keys", {{0, 2.0}, {10, value}}}};
    };
    EXPECT_EQ(complaint_with("/render/sky/turbidity", keys(3.0)), "");
    EXPECT_NE(complaint_with("/render/sky/turbidity", keys(300.0)), "");
}

TEST(Schema, MissingKeysAreNoticed) {
    Json scene = full();
    scene["render"]["camera"][0].erase("name");
    EXPECT_NE(validator().complaint(scene), "");
    scene = full();
    scene["terrain"]["stage"][0].erase("method");
    EXPECT_NE(validator().complaint(scene), "");
}

TEST(Schema, WordsThatStandForANumberAreAllowed) {
    EXPECT_EQ(complaint_with("/render/haze", Json{{"visibility", "auto"}}), "");
    EXPECT_EQ(complaint_with("/render/haze", Json{{"visibility", "5.5 %"}}), "");
    EXPECT_NE(complaint_with("/render/haze", Json{{"visibility", "automatic"}}), "");
}

}  // namespace cydonia::config
