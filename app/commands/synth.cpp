#include <CLI/CLI.hpp>

#include <memory>

#include "app/commands/commands.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {

void add_synth(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    const auto tile = std::make_shared<std::vector<int>>();
    CLI::App* command =
        add_command(app, {"synth", "Make the terrain only",
                          "synth scenes/text/scene.toml --set terrain.samples=1024"});
    add_scene(*command, *request)->required();
    add_making_options(*command, *request);
    command
        ->add_option("--tile", *tile, "only this one, counted from 0 at the north-west")
        ->type_name("COLUMN,ROW")
        ->delimiter(',')
        ->expected(2)
        ->allow_extra_args(false);
    command->callback([request, tile, &action] {
        if (tile->size() == 2) request->tile = {tile->at(0), tile->at(1)};
        action = [request] {
            Console console(style_for_stderr(request->quiet));
            make(*request, Goal::kTerrain, console);
        };
    });
}

}  // namespace cydonia
