#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "app/commands/commands.h"
#include "app/describe.h"
#include "config/reader/scene.h"

namespace cydonia {

void add_validate(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    CLI::App* command =
        add_command(app, {"validate", "Check the scene file only",
                          "validate scenes/text/scene.toml --set terrain.samples=64"});
    add_scene(*command, *request)->required();
    command->callback([request, &action] {
        action = [request] {
            const auto spec =
                config::Scene::load(request->scene, request->overrides).at(0.0);
            if (!request->quiet) fmt::print("{}", description(spec));
        };
    });
}

}  // namespace cydonia
