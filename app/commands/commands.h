#pragma once

#include <functional>
#include <string>

#include "app/console.h"
#include "app/request.h"

// CLI11's header takes seconds to compile: only files that declare options include it.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace cydonia {

// What main does after it has read the command line.
using Action = std::function<void()>;

// Every subcommand, in the order of the overview. Each is a function in a file of this
// folder, which adds the subcommand to the command line and, if the user asked for it,
// sets the action. Those under ALSO are only named in the last line of the overview,
// which has to fit a screen.
#define CYDONIA_SUBCOMMANDS(SHOWN, ALSO) \
    SHOWN(add_new)                       \
    SHOWN(add_render)                    \
    SHOWN(add_sequences)                 \
    SHOWN(add_farm)                      \
    SHOWN(add_watch)                     \
    SHOWN(add_synth)                     \
    SHOWN(add_check)                     \
    SHOWN(add_report)                    \
    SHOWN(add_export)                    \
    ALSO(add_emit)                       \
    ALSO(add_frame_for_sketch)           \
    ALSO(add_gallery)                    \
    ALSO(add_info)                       \
    ALSO(add_library)                    \
    ALSO(add_reproduce)                  \
    ALSO(add_schema)                     \
    ALSO(add_validate)

#define CYDONIA_DECLARE(add) void add(CLI::App& app, Action& action);
CYDONIA_SUBCOMMANDS(CYDONIA_DECLARE, CYDONIA_DECLARE)
#undef CYDONIA_DECLARE

struct Help {
    std::string name;
    std::string description;
    std::string example;  // "render scene.toml"; every help ends with one
};

// Adds a subcommand that makes something from a scene: SCENE and all shared options.
void add_making_command(CLI::App& app, Action& action, const Help& help,
                        const std::function<void(const Request&, Console&)>& make);

// The parts of a subcommand: its help; SCENE with --set and --quiet; the options of
// whatever makes files.
CLI::App* add_command(CLI::App& app, const Help& help);
CLI::Option* add_scene(CLI::App& command, Request& request);
void add_making_options(CLI::App& command, Request& request);
// --quality and --threads, which are two of these.
void add_effort_options(CLI::App& command, Request& request);

// --engine and --style, for commands that draw frames; and a check of the two together.
void add_engine(CLI::App& command, Request& request);
void check_engine(const CLI::App& command, const Request& request);
void add_size(CLI::App& command, Request& request);
// --frames N: how many, by default the scene's number or `count`. --frames A-B: which.
void add_frames(CLI::App& command, Request& request, const std::string& count);

// Sets how the program and its subcommands print help.
void format_plainly(CLI::App& app);

}  // namespace cydonia
