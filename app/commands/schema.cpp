#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include "app/commands/commands.h"
#include "app/pipeline/ledger.h"
#include "config/reader/scene.h"

namespace cydonia {

void add_schema(CLI::App& app, Action& action) {
    CLI::App* command =
        add_command(app, {"schema", "Print the JSON Schema of scene files, for editors",
                          "schema > scene.schema.json"});
    command->callback([&action] {
        action = [] { fmt::print("{}\n", Json::parse(config::scene_schema()).dump(1)); };
    });
}

}  // namespace cydonia
