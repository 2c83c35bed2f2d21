#include <CLI/CLI.hpp>

#include <memory>

#include "app/commands/commands.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {

namespace {

// Only solids are scaled; the other formats are in metres.
void check_solid(const CLI::App& command, const ExportRequest& asked) {
    if (std::holds_alternative<MeshFormat>(asked.format)) return;
    for (const char* name : {"--size", "--base", "--scale-z"})
        if (command.get_option(name)->count() > 0)
            throw CLI::ValidationError(
                std::string(name) + " is for the solids stl, obj and ply; " +
                std::string(name_of(asked.format)) + " is in metres, true to scale");
}

}  // namespace

void add_export(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    ExportRequest& asked = request->export_as.emplace();
    CLI::App* command = add_command(
        app, {"export", "Make the land a file for printers and other programs",
              "export scenes/text/scene.toml --to stl --size 200"});
    add_scene(*command, *request)->required();
    command
        ->add_option_function<std::string>(
            "--to",
            [&asked](const std::string& name) {
                asked.format = export_formats().at(name);
            },
            "[stl] obj ply glb ter tif png16 raw16 raw32 exr xyz")
        ->check(CLI::IsMember(export_formats()).description(""))
        ->type_name("NAME");
    const auto add_number = [&](const char* name, auto& value, const char* type,
                                const char* description) {
        command->add_option(name, value, description)->type_name(type);
    };
    SolidOptions& solid = asked.solid;
    add_number("--size", solid.size, "MM", "of a solid's longer side [150]");
    add_number("--base", solid.base, "MM", "plate under the lowest ground [3]");
    add_number("--scale-z", solid.scale_z, "F", "a solid's heights times this [1]");
    add_number("--samples", asked.samples, "N",
               "at most, on the longer side [512; heights: all]");
    add_making_options(*command, *request);
    command->remove_option(command->get_option("--force"));
    command->callback([request, command, &action] {
        check_solid(*command, *request->export_as);
        action = [request] {
            Console console(style_for_stderr(request->quiet));
            make(*request, Goal::kTerrain, console);
        };
    });
}

}  // namespace cydonia
