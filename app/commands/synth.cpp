#include "app/commands/commands.h"
#include "app/console.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {

void add_synth(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    CLI::App* command =
        add_command(app, "synth", "Make the terrain only",
                    "synth scenes/text/scene.toml --set terrain.samples=1024");
    add_scene(*command, *request)->required();
    add_making_options(*command, *request);
    command->callback([request, &action] {
        action = [request] {
            Console console(style_for_stderr(request->quiet));
            make(*request, Goal::kTerrain, console);
        };
    });
}

}  // namespace cydonia
