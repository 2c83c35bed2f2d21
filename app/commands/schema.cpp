#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include "app/commands/commands.h"
#include "app/manual.h"
#include "app/pipeline/ledger.h"
#include "config/reader/scene.h"

namespace cydonia {
namespace {

// What editors show of a key, where they stand: in the schema of a table, of an array of
// such, of one of several.
void describe(Json& schema, const std::string& path, const Manual& manual) {
    if (schema.contains("items") && schema["items"].is_object())
        describe(schema["items"], path, manual);
    if (schema.contains("anyOf"))
        for (Json& one : schema["anyOf"]) describe(one, path, manual);
    if (!schema.contains("properties")) return;
    Json& keys = schema["properties"];
    std::string table = path;
    if (path == "terrain.stage")
        table += ' ' + keys.at("method").at("enum").at(0).get<std::string>();
    for (auto& [key, value] : keys.items()) {
        const std::string meaning = manual.meaning(table, key);
        if (!meaning.empty()) value["description"] = meaning;
        describe(value, path.empty() ? key : path + '.' + key, manual);
    }
}

}  // namespace

void add_schema(CLI::App& app, Action& action) {
    CLI::App* command =
        add_command(app, {"schema", "Print the JSON Schema of scene files, for editors",
                          "schema > scene.schema.json"});
    command->callback([&action] {
        action = [] {
            Json schema = Json::parse(config::scene_schema());
            describe(schema, "", Manual::load());
            fmt::print("{}\n", schema.dump(1));
        };
    });
}

}  // namespace cydonia
