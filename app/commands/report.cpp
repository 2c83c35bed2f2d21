#include "app/commands/commands.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {

void add_report(CLI::App& app, Action& action) {
    const Help help{"report", "Show all there is of a scene on one page",
                    "report scenes/text/scene.toml && xdg-open out/text/report.html"};
    add_making_command(app, action, help, [](const Request& request, Console& console) {
        make(request, Goal::kReport, console);
    });
}

}  // namespace cydonia
