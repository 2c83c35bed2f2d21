#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <memory>

#include "app/commands/commands.h"
#include "app/pipeline/pipeline.h"
#include "config/reader/scene.h"

namespace cydonia {
namespace {

void add_sequence(CLI::App& app, Action& action, const Help& help, Goal goal,
                  const std::string& count) {
    const auto request = std::make_shared<Request>();
    const auto frames = std::make_shared<int>(0);
    CLI::App* command = add_command(app, help);
    add_scene(*command, *request)->required();
    add_making_options(*command, *request);
    add_engine(*command, *request);
    add_size(*command, *request);
    command->add_option("--frames", *frames, "how many [the scene's, else " + count + "]")
        ->check(CLI::Range(1, config::kMostFrames).description(""))
        ->type_name("N");
    command->callback([request, frames, goal, command, &action] {
        check_engine(*command, *request);
        if (*frames > 0)
            request->overrides.push_back(fmt::format("frames.count={}", *frames));
        action = [request, goal] {
            Console console(style_for_stderr(request->quiet));
            make(*request, goal, console);
        };
    });
}

}  // namespace

void add_sequences(CLI::App& app, Action& action) {
    add_sequence(app, action,
                 {"sweep", "Film a day in which the image appears",
                  "sweep scenes/text/scene.toml --quality draft"},
                 Goal::kSweep, "48");
    add_sequence(app, action,
                 {"turntable", "Film the land from all around",
                  "turntable scenes/text/scene.toml --frames 48"},
                 Goal::kTurntable, "48");
    add_sequence(app, action,
                 {"film", "Film what the scene's keys and camera paths do",
                  "film scenes/flight/scene.toml --quality draft"},
                 Goal::kFilm, "all keys'");
}

}  // namespace cydonia
