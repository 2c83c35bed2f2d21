#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/commands.h"
#include "config/reader/scene.h"

namespace cydonia {
namespace {

// Prints an option's name and the type of its value. Ranges and choices are in its
// description.
class Formatter final : public CLI::Formatter {
  public:
    std::string make_option_opts(const CLI::Option* option) const override {
        return option->get_type_name().empty() ? "" : " " + option->get_type_name();
    }
};

// The names of an enum's table.
template <class E, std::size_t N>
CLI::Validator is_one_of(const Name<E> (&table)[N]) {
    std::vector<std::string> names;
    for (const Name<E>& row : table) names.emplace_back(row.name);
    return CLI::IsMember(std::move(names)).description("");
}

}  // namespace

CLI::App* add_command(CLI::App& app, const Help& help) {
    CLI::App* command = app.add_subcommand(help.name, help.description);
    command->footer("Example:\n  cydonia " + help.example + "\n");
    return command;
}

void add_making_command(CLI::App& app, Action& action, const Help& help,
                        const std::function<void(const Request&, Console&)>& make) {
    const auto request = std::make_shared<Request>();
    CLI::App* command = add_command(app, help);
    add_scene(*command, *request)->required();
    add_making_options(*command, *request);
    command->callback([request, make, &action] {
        action = [request, make] {
            Console console(style_for_stderr(request->quiet));
            make(*request, console);
        };
    });
}

void format_plainly(CLI::App& app) {
    app.formatter(std::make_shared<Formatter>());
    app.get_formatter()->column_width(26);
}

CLI::Option* add_scene(CLI::App& command, Request& request) {
    command.add_flag("--quiet", request.quiet, "print errors only");
    command
        .add_option("--set", request.overrides, "set any key of the scene; repeatable")
        ->allow_extra_args(false)
        ->type_name("KEY=VALUE");
    return command.add_option("SCENE", request.scene, "the scene file")->type_name("");
}

void add_effort_options(CLI::App& command, Request& request) {
    const auto take = [&request](const std::string& name) {
        request.quality = *value_in(render::kQualities, name);
    };
    command
        .add_option_function<std::string>(
            "--quality", take,
            fmt::format("{} [{}]", choices_in(render::kQualities),
                        name_of(request.quality)))
        ->check(is_one_of(render::kQualities))
        ->type_name("NAME");
    command.add_option("--threads", request.threads, "use at most N threads [all]")
        ->check(CLI::Range(1, 1024).description(""))
        ->type_name("N");
}

void add_making_options(CLI::App& command, Request& request) {
    command.add_option("-o", request.output, "output folder [out/<scene>]")
        ->type_name("DIR");
    add_effort_options(command, request);
    command.add_flag("--force", request.force, "go on when the shadow check falls short");
    command.add_flag("--explain", request.explain,
                     "show how stages came to their land, in <DIR>/explain");
    command.add_flag("--dry-run", request.dry_run,
                     "print the plan, what is done and predicted memory only");
}

void add_engine(CLI::App& command, Request& request) {
    const auto engine = [&request](const std::string& name) {
        if (name == "embree" && !request.preview)
            request.preview = render::Style::kNatural;
    };
    command
        .add_option_function<std::string>(
            "--engine", engine, "povray, or embree for a look in a second [povray]")
        ->check(CLI::IsMember({"povray", "embree"}).description(""))
        ->type_name("NAME");
    const auto style = [&request](const std::string& name) {
        request.preview = value_in(render::kStyles, name);
    };
    command
        .add_option_function<std::string>(
            "--style", style, "of embree: natural, grey, ink, contours, ... [natural]")
        ->check(is_one_of(render::kStyles))
        ->type_name("NAME")
        ->needs("--engine");
}

void check_engine(const CLI::App& command, const Request& request) {
    if (request.preview && command.get_option("--engine")->as<std::string>() != "embree")
        throw CLI::ValidationError("--style is for --engine embree only");
}

void add_size(CLI::App& command, Request& request) {
    const auto size = [&request](const std::string& text) {
        std::array<int, 2> asked{};
        char rest = 0;
        if (std::sscanf(text.c_str(), "%5dx%5d%c", &asked[0], &asked[1], &rest) != 2 ||
            std::min(asked[0], asked[1]) < 16 || std::max(asked[0], asked[1]) > 16384)
            throw CLI::ValidationError(
                "--size is width x height, 16 to 16384 pixels each, as in 640x360");
        request.size = asked;
    };
    command
        .add_option_function<std::string>(
            "--size", size, "pixels of every frame [the scene's, by quality]")
        ->type_name("WxH");
}

void add_frames(CLI::App& command, Request& request, const std::string& count) {
    const auto frames = [&request](const std::string& text) {
        constexpr int kMost = config::kMostFrames;
        int first = 0, last = 0;
        char rest = 0;
        if (std::sscanf(text.c_str(), "%5d-%5d%c", &first, &last, &rest) == 2 &&
            0 <= first && first <= last && last < kMost) {
            request.frames = {first, last};
        } else if (std::sscanf(text.c_str(), "%5d%c", &first, &rest) == 1 && 1 <= first &&
                   first <= kMost) {
            request.overrides.push_back(fmt::format("frames.count={}", first));
        } else {
            throw CLI::ValidationError(fmt::format(
                "--frames is how many, 1 to {}, or the first and the last of those to "
                "make, from 0, as in 0-239",
                kMost));
        }
    };
    command
        .add_option_function<std::string>(
            "--frames", frames,
            "how many [the scene's, else " + count + "], or A-B: which")
        ->type_name("N");
}

}  // namespace cydonia
