#include "app/commands/commands.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {

void add_emit(CLI::App& app, Action& action) {
    const Help help{
        "emit", "Make everything up to the .pov, for POV-Ray by hand",
        "emit scenes/text/scene.toml && cd out/text/pov && povray overhead.ini"};
    add_making_command(app, action, help, [](const Request& request, Console& console) {
        make(request, Goal::kEmit, console);
    });
}

}  // namespace cydonia
