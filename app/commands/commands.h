#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "app/request.h"
#include "field/error.h"

namespace cydonia {

// Every subcommand adds itself to the command line and, when it is the one asked for,
// sets what main then does.
using Action = std::function<void()>;

void add_render(CLI::App& app, Action& action);
void add_synth(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_emit(CLI::App& app, Action& action);
void add_validate(CLI::App& app, Action& action);
void add_info(CLI::App& app, Action& action);

// A subcommand whose help ends with an example, "render scene.toml".
CLI::App* add_command(CLI::App& app, const std::string& name,
                      const std::string& description, const std::string& example);

// How help is printed, by the program and its subcommands.
void format_plainly(CLI::App& app);

// Options that commands share: SCENE, --set and --quiet, and what making takes besides.
CLI::Option* add_scene(CLI::App& command, Request& request);
void add_making_options(CLI::App& command, Request& request);

}  // namespace cydonia
