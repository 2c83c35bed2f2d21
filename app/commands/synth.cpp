#include "app/commands/commands.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {

void add_synth(CLI::App& app, Action& action) {
    const Help help{"synth", "Make the terrain only",
                    "synth scenes/text/scene.toml --set terrain.samples=1024"};
    add_making_command(app, action, help, [](const Request& request, Console& console) {
        make(request, Goal::kTerrain, console);
    });
}

}  // namespace cydonia
