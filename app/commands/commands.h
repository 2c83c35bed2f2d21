#pragma once

#include <functional>
#include <string>

#include "app/console.h"
#include "app/request.h"

// Its header takes seconds to compile: only what declares options includes it.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace cydonia {

// What main does once the command line is read.
using Action = std::function<void()>;

// Every subcommand, in the order of the overview. Each is a function of a file in this
// folder that adds it to the command line and, when it is the one asked for, sets the
// action. ALSO: named in the overview's last line only, so that it fits a screen.
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

// A subcommand that makes something of a scene: SCENE and all shared options.
void add_making_command(CLI::App& app, Action& action, const Help& help,
                        const std::function<void(const Request&, Console&)>& make);

// The pieces of a subcommand: its help, SCENE with --set and --quiet, and the options
// that making takes besides.
CLI::App* add_command(CLI::App& app, const Help& help);
CLI::Option* add_scene(CLI::App& command, Request& request);
void add_making_options(CLI::App& command, Request& request);
// --quality and --threads, which are two of them.
void add_effort_options(CLI::App& command, Request& request);

// --engine and --style, of what draws frames; and what they may not be together.
void add_engine(CLI::App& command, Request& request);
void check_engine(const CLI::App& command, const Request& request);
void add_size(CLI::App& command, Request& request);
// --frames N, how many, [the scene's, else `count`], or --frames A-B, which.
void add_frames(CLI::App& command, Request& request, const std::string& count);

// How help is printed, by the program and its subcommands.
void format_plainly(CLI::App& app);

}  // namespace cydonia
