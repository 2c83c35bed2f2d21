#include "app/commands/commands.h"
#include "app/console.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {

void add_emit(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    CLI::App* command = add_command(
        app, "emit", "Make everything up to the .pov, for POV-Ray by hand",
        "emit scenes/text/scene.toml && cd out/text/pov && povray overhead.ini");
    add_scene(*command, *request)->required();
    add_making_options(*command, *request);
    command->callback([request, &action] {
        action = [request] {
            Console console(style_for_stderr(request->quiet));
            make(*request, Goal::kEmit, console);
        };
    });
}

}  // namespace cydonia
