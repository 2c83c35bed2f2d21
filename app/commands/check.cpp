#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "app/commands/commands.h"
#include "app/console.h"
#include "app/pipeline/height_check.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {

void add_check(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    const auto heights = std::make_shared<HeightCheck>();
    const auto angles = std::make_shared<std::vector<double>>();
    CLI::App* command =
        add_command(app, {"check", "Cast the shadows and compare them only",
                          "check --height dem.tif --sun 215,25 --target t.png"});
    CLI::Option* scene = add_scene(*command, *request);
    CLI::Option* height =
        command
            ->add_option("--height", heights->height, "a height file instead of a scene")
            ->type_name("FILE")
            ->excludes(scene);
    CLI::Option* sun =
        command->add_option("--sun", *angles, "with --height: its sun, in degrees")
            ->type_name("AZIMUTH,ELEVATION")
            ->delimiter(',')
            ->expected(2)
            ->allow_extra_args(false)
            ->needs(height);
    CLI::Option* target =
        command->add_option("--target", heights->target, "with --height: dark is shadow")
            ->type_name("IMAGE")
            ->needs(height);
    command
        ->add_option("--window", heights->window,
                     "with --height: white where shadows count")
        ->type_name("IMAGE")
        ->needs(height);
    add_making_options(*command, *request);
    height->needs(sun)->needs(target);
    for (const char* of_scenes : {"--set", "--explain"}) {
        height->excludes(command->get_option(of_scenes));
    }
    command->callback([request, heights, angles, &action] {
        if (angles->size() == 2) {
            heights->azimuth = angles->at(0);
            heights->elevation = angles->at(1);
        }
        action = [request, heights] {
            Console console(style_for_stderr(request->quiet));
            if (!heights->height.empty())
                return check_height(*heights, *request, console);
            if (!request->scene.empty()) return make(*request, Goal::kCheck, console);
            throw bad_request(
                "check needs a scene file or --height (see cydonia check --help)");
        };
    });
}

}  // namespace cydonia
