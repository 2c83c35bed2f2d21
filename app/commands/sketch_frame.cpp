#include <CLI/CLI.hpp>

#include <memory>

#include "app/commands/commands.h"
#include "app/sketch_frame.h"

namespace cydonia {

void add_frame_for_sketch(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    CLI::App* command = add_command(
        app, {"frame-for-sketch", "Write frames as drawings to sketch skylines over",
              "frame-for-sketch scenes/sketched/scene.toml"});
    add_scene(*command, *request)->required();
    command->add_option("-o", request->output, "output folder [out/<scene>]")
        ->type_name("DIR");
    add_effort_options(*command, *request);
    add_size(*command, *request);
    command->add_flag("--force", request->force, "replace drawings that have strokes");
    command->callback([request, &action] {
        action = [request] {
            Console console(style_for_stderr(request->quiet));
            frame_for_sketch(*request, console);
        };
    });
}

}  // namespace cydonia
