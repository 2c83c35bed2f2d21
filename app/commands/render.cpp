#include "app/commands/commands.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {

void add_render(CLI::App& app, Action& action) {
    const Help help{"render", "Make everything: terrain, check, .pov, frames",
                    "render scenes/text/scene.toml --quality draft"};
    add_making_command(app, action, help, [](const Request& request, Console& console) {
        make(request, Goal::kFrames, console);
    });
}

}  // namespace cydonia
