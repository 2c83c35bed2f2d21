#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "app/commands/commands.h"
#include "app/pipeline/pipeline.h"

namespace cydonia {
namespace {

void add_engine(CLI::App& command, Request& request) {
    using render::Style;
    static const std::map<std::string, Style> kStyles = {
        {"natural", Style::kNatural},  {"grey", Style::kGrey},
        {"height", Style::kHeight},    {"slope", Style::kSlope},
        {"ink", Style::kInk},          {"contours", Style::kContours},
        {"radiance", Style::kRadiance}};
    const auto engine = [&request](const std::string& name) {
        if (name == "embree" && !request.preview) request.preview = Style::kNatural;
    };
    command
        .add_option_function<std::string>(
            "--engine", engine, "povray, or embree for a look in a second [povray]")
        ->check(CLI::IsMember({"povray", "embree"}).description(""))
        ->type_name("NAME");
    const auto style = [&request](const std::string& name) {
        request.preview = kStyles.at(name);
    };
    command
        .add_option_function<std::string>(
            "--style", style, "of embree: natural, grey, ink, contours, ... [natural]")
        ->check(CLI::IsMember(kStyles).description(""))
        ->type_name("NAME")
        ->needs("--engine");
}

}  // namespace

void add_render(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    CLI::App* command =
        add_command(app, {"render", "Make everything: terrain, check, .pov, frames",
                          "render scenes/text/scene.toml --quality draft"});
    add_scene(*command, *request)->required();
    add_making_options(*command, *request);
    add_engine(*command, *request);
    command->callback([request, command, &action] {
        const CLI::Option* engine = command->get_option("--engine");
        if (request->preview && engine->as<std::string>() != "embree")
            throw CLI::ValidationError("--style is for --engine embree only");
        action = [request] {
            Console console(style_for_stderr(request->quiet));
            make(*request, Goal::kFrames, console);
        };
    });
}

}  // namespace cydonia
