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

// Every subcommand adds itself to the command line and, when it is the one asked for,
// sets what main then does.
using Action = std::function<void()>;

void add_render(CLI::App& app, Action& action);
void add_synth(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_emit(CLI::App& app, Action& action);
void add_sequences(CLI::App& app, Action& action);  // sweep, turntable, film
void add_farm(CLI::App& app, Action& action);
void add_new(CLI::App& app, Action& action);
void add_validate(CLI::App& app, Action& action);
void add_watch(CLI::App& app, Action& action);
void add_info(CLI::App& app, Action& action);
void add_gallery(CLI::App& app, Action& action);
void add_export(CLI::App& app, Action& action);
void add_library(CLI::App& app, Action& action);
void add_frame_for_sketch(CLI::App& app, Action& action);
void add_reproduce(CLI::App& app, Action& action);
void add_schema(CLI::App& app, Action& action);

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
