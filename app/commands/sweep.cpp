#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <memory>

#include "app/commands/commands.h"
#include "app/pipeline/pipeline.h"
#include "config/reader/scene.h"

namespace cydonia {

void add_sweep(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    const auto frames = std::make_shared<int>(0);
    CLI::App* command =
        add_command(app, {"sweep", "Film a day in which the image appears",
                          "sweep scenes/text/scene.toml --quality draft"});
    add_scene(*command, *request)->required();
    add_making_options(*command, *request);
    command->add_option("--frames", *frames, "how many [the scene's, else 48]")
        ->check(CLI::Range(1, config::kMostFrames).description(""))
        ->type_name("N");
    command->callback([request, frames, &action] {
        if (*frames > 0)
            request->overrides.push_back(fmt::format("frames.count={}", *frames));
        action = [request] {
            Console console(style_for_stderr(request->quiet));
            make(*request, Goal::kSweep, console);
        };
    });
}

}  // namespace cydonia
