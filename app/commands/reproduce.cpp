#include "app/reproduce/reproduce.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"

namespace cydonia {

void add_reproduce(CLI::App& app, Action& action) {
    struct Asked {
        std::filesystem::path manifest;
        std::optional<std::filesystem::path> output;
        bool quiet = false;
    };
    const auto asked = std::make_shared<Asked>();
    CLI::App* command =
        add_command(app, {"reproduce", "Make all files of a manifest again and compare",
                          "reproduce out/text/manifest.json"});
    command->add_flag("--quiet", asked->quiet, "print the comparison and errors only");
    command->add_option("-o", asked->output, "output folder [a temporary one]")
        ->type_name("DIR");
    command->add_option("MANIFEST", asked->manifest, "a manifest.json")
        ->type_name("")
        ->required();
    command->callback([asked, &action] {
        action = [asked] {
            Console console(style_for_stderr(asked->quiet));
            reproduce(asked->manifest, asked->output, console);
        };
    });
}

}  // namespace cydonia
