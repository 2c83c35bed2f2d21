#include "app/farm/farm.h"

#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "app/commands/commands.h"
#include "field/error.h"

namespace cydonia {
namespace {

using OnFarm = void (*)(const Request&, Console&);

void add_on(CLI::App& farm, Action& action, const Help& help, OnFarm what) {
    const auto request = std::make_shared<Request>();
    CLI::App* command = add_command(farm, help);
    add_scene(*command, *request)->required();
    command->add_option("-o", request->output, "output folder [out/<scene>]")
        ->type_name("DIR");
    command->callback([request, what, &action] {
        action = [request, what] {
            Console console(style_for_stderr(request->quiet));
            what(*request, console);
        };
    });
}

}  // namespace

void add_farm(CLI::App& app, Action& action) {
    static const std::map<std::string, Kind> kSequences = {
        {"turntable", Kind::kTurntable}, {"film", Kind::kFilm}, {"sweep", Kind::kDay}};
    const auto asked = std::make_shared<FarmRequest>();
    Request& request = asked->request;
    CLI::App* command =
        add_command(app, {"farm", "Film on many machines (and farm status, collect)",
                          "farm scenes/text/scene.toml --frames 0-239 --dry-run"});
    CLI::Option* scene = add_scene(*command, request);
    add_making_options(*command, request);
    command->remove_option(command->get_option("--explain"));
    command->remove_option(command->get_option("--threads"));
    add_size(*command, request);
    add_frames(*command, request, "48");
    command
        ->add_option_function<std::string>(
            "--sequence",
            [asked](const std::string& name) { asked->sequence = kSequences.at(name); },
            "turntable, film or sweep [film of what moves]")
        ->check(CLI::IsMember(kSequences).description(""))
        ->type_name("NAME");
    command->add_option("--chunk", asked->chunk, "frames a task [8, 4 or 1 by quality]")
        ->check(CLI::Range(1, 9999).description(""))
        ->type_name("N");
    command->add_option("--minutes", asked->minutes, "time limit of a task [by quality]")
        ->check(CLI::Range(1, 100000).description(""))
        ->type_name("N");
    command->require_subcommand(0, 1);
    add_on(*command, action,
           {"status", "Print how far it is", "farm status scenes/text/scene.toml"},
           farm_status);
    add_on(*command, action,
           {"collect", "Make pictures, videos and report of traced frames",
            "farm collect scenes/text/scene.toml"},
           farm_collect);
    for (const char* name : {"status", "collect"})
        command->get_subcommand(name)->group("");
    command->callback([asked, scene, command, &action] {
        if (!command->get_subcommands().empty()) return;  // which sets its own
        if (scene->count() == 0) throw CLI::RequiredError("SCENE");
        action = [asked] {
            Console console(style_for_stderr(asked->request.quiet));
            farm(*asked, console);
        };
    });
}

}  // namespace cydonia
