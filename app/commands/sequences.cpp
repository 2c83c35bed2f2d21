#include <CLI/CLI.hpp>

#include <memory>

#include "app/commands/commands.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {
namespace {

void add_sequence(CLI::App& app, Action& action, const Help& help, Goal goal,
                  const std::string& count) {
    const auto request = std::make_shared<Request>();
    CLI::App* command = add_command(app, help);
    add_scene(*command, *request)->required();
    add_making_options(*command, *request);
    command->remove_option(command->get_option("--explain"));  // of stills
    add_engine(*command, *request);
    add_size(*command, *request);
    add_frames(*command, *request, count);
    command->add_flag("--trace-only", request->trace_only)->group("");  // of farms
    command->callback([request, goal, command, &action] {
        check_engine(*command, *request);
        if (request->trace_only && (!request->frames || request->preview))
            throw CLI::ValidationError("--trace-only is for --frames A-B by POV-Ray");
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
