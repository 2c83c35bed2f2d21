#include <CLI/CLI.hpp>

#include <memory>

#include "app/commands/commands.h"
#include "app/library.h"

namespace cydonia {
namespace {

using Work = void (*)(const LibraryRequest&, Console&);

void add(CLI::App& command, Action& action, const Help& help, bool with_land, Work work) {
    const auto request = std::make_shared<LibraryRequest>();
    CLI::App* sub = add_command(command, help);
    sub->add_option("LIB", request->library, "the library's TOML file")
        ->type_name("")
        ->required();
    if (with_land)
        sub->add_option("FILE", request->land, "an elevation model")
            ->type_name("")
            ->required();
    sub->add_option("-o", request->output, "keeps analyses there [out/<library>]")
        ->type_name("DIR");
    sub->add_flag("--quiet", request->quiet, "print the tables only");
    sub->add_option("--threads", request->threads, "use at most N threads [all]")
        ->check(CLI::Range(1, 1024).description(""))
        ->type_name("N");
    sub->callback([request, work, &action] {
        action = [request, work] {
            Console console(style_for_stderr(request->quiet));
            work(*request, console);
        };
    });
}

}  // namespace

void add_library(CLI::App& app, Action& action) {
    CLI::App* command =
        add_command(app, {"library", "Say what kinds of land a library knows",
                          "library classify scenes/libraries/land.toml dem.tif"});
    command->require_subcommand(1);
    add(*command, action,
        {"analyse", "How well examples of each type agree",
         "library analyse scenes/libraries/land.toml"},
        false, analyse_library);
    add(*command, action,
        {"compare", "How like each type a land is",
         "library compare scenes/libraries/land.toml dem.tif"},
        true, compare_with_library);
    add(*command, action,
        {"classify", "Which type a land fits best, and which it is made of",
         "library classify scenes/libraries/land.toml dem.tif"},
        true, classify_by_library);
}

}  // namespace cydonia
