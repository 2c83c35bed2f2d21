#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "app/commands/commands.h"
#include "app/describe.h"

namespace cydonia {

void add_info(CLI::App& app, Action& action) {
    const auto file = std::make_shared<std::filesystem::path>();
    CLI::App* command =
        add_command(app, {"info", "Say what a file holds", "info out/text/terrain.exr"});
    command
        ->add_option("FILE", *file, "a scene, heights, a frame or image, or a manifest")
        ->type_name("")
        ->required();
    command->callback(
        [file, &action] { action = [file] { fmt::print("{}", description(*file)); }; });
}

}  // namespace cydonia
