#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {
void add_render(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    CLI::App* command =
        add_command(app, {"render", "Make everything: terrain, check, .pov, frames",
                          "render scenes/text/scene.toml --quality draft"});
    add_scene(*command, *request)->required();
    add_making_options(*command, *request);
    add_engine(*command, *request);
    add_size(*command, *request);
    command->callback([request, command, &action] {
        check_engine(*command, *request);
        action = [request] {
            Console console(style_for_stderr(request->quiet));
            make(*request, Goal::kFrames, console);
        };
    });
}

}  // namespace cydonia
