#include <CLI/CLI.hpp>

#include <map>
#include <memory>

#include "app/commands/commands.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {

void add_export(CLI::App& app, Action& action) {
    static const std::map<std::string, MeshFormat> kFormats = {{"stl", MeshFormat::kStl},
                                                               {"obj", MeshFormat::kObj},
                                                               {"ply", MeshFormat::kPly},
                                                               {"glb", MeshFormat::kGlb}};
    const auto request = std::make_shared<Request>();
    SolidRequest& solid = request->solid.emplace();
    CLI::App* command = add_command(
        app, {"export", "Make the land a solid to print and light with a lamp",
              "export scenes/text/scene.toml --to stl --size 200"});
    add_scene(*command, *request)->required();
    command
        ->add_option_function<std::string>(
            "--to",
            [&solid](const std::string& name) { solid.format = kFormats.at(name); },
            "stl, obj, ply or glb [stl]")
        ->check(CLI::IsMember(kFormats).description(""))
        ->type_name("NAME");
    const auto add_number = [&](const char* name, auto& value, const char* type,
                                const char* description) {
        command->add_option(name, value, description)->type_name(type);
    };
    SolidOptions& options = solid.options;
    add_number("--size", options.size, "MM", "millimetres of its longer side [150]");
    add_number("--base", options.base, "MM", "plate under the lowest ground [3]");
    add_number("--scale-z", options.scale_z, "F", "heights times this [1]");
    add_number("--samples", options.samples, "N", "at most, on the longer side [512]");
    add_making_options(*command, *request);
    for (const char* of_frames : {"--quality", "--force"})
        command->remove_option(command->get_option(of_frames));
    command->callback([request, &action] {
        action = [request] {
            Console console(style_for_stderr(request->quiet));
            make(*request, Goal::kTerrain, console);
        };
    });
}

}  // namespace cydonia
