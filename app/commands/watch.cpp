#include "app/watch.h"

#include <CLI/CLI.hpp>

#include <memory>

#include "app/commands/commands.h"

namespace cydonia {

void add_watch(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    CLI::App* command =
        add_command(app, {"watch", "Draw a look at the scene again on each save",
                          "watch scenes/text/scene.toml"});
    add_scene(*command, *request)->required();
    command->add_option("-o", request->output, "output folder [out/<scene>]")
        ->type_name("DIR");
    add_engine(*command, *request);
    CLI::Option* engine = command->get_option("--engine");  // there is one only
    command->get_option("--style")->remove_needs(engine);
    command->remove_option(engine);
    add_size(*command, *request);
    command->callback([request, &action] { action = [request] { watch(*request); }; });
}

}  // namespace cydonia
