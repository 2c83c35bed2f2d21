#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>

#include "app/commands/commands.h"
#include "app/interrupt.h"
#include "field/error.h"
#include "field/progress.h"

using namespace cydonia;

namespace {

void describe(CLI::App& app) {
    app.name("cydonia");
    app.description("Cydonia turns a scene file into film frames of a landscape.");
    app.set_version_flag("--version", "cydonia " CYDONIA_VERSION, "print the version");
    app.set_help_flag("-h,--help", "print this help");
    app.require_subcommand(0, 1);
    format_plainly(app);
}

using Add = void (*)(CLI::App&, Action&);

void add_commands(CLI::App& app, Action& action) {
    std::string also;
    const auto shown = [&](Add add) { add(app, action); };
    const auto not_shown = [&](Add add) {
        add(app, action);
        CLI::App* command = app.get_subcommands({}).back();
        command->group("");
        also += " " + command->get_name();
    };
#define CYDONIA_SHOWN(add) shown(add);
#define CYDONIA_ALSO(add) not_shown(add);
    CYDONIA_SUBCOMMANDS(CYDONIA_SHOWN, CYDONIA_ALSO)
#undef CYDONIA_SHOWN
#undef CYDONIA_ALSO
    app.footer("Also:" + also +
               "\nExample:\n  cydonia render scenes/text/scene.toml --quality draft\n");
}

int exit_code(ExitCode code) { return static_cast<int>(code); }

// Prints one line about a wrong command line, ending with where help is.
int wrong_usage(const CLI::App& app, const CLI::ParseError& error) {
    const auto chosen = app.get_subcommands();
    const std::string command =
        chosen.empty() ? "cydonia" : "cydonia " + chosen.front()->get_name();
    std::string message = error.what();
    if (const auto extra = app.remaining(true); !extra.empty()) {
        message =
            fmt::format("'{}' is not something that {} takes", extra.front(), command);
    }
    fmt::print(stderr, "cydonia: {} (see {} --help)\n", message, command);
    return exit_code(ExitCode::kBadRequest);
}

// Messages quote names from files, whose control characters must not reach the terminal.
std::string printable(std::string message) {
    std::ranges::replace_if(
        message, [](unsigned char c) { return (c < 32 && c != '\n') || c == 127; }, '?');
    return message;
}

int run(const Action& action) try {
    action();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw failure("cannot write to the standard output: {}", std::strerror(errno));
    return exit_code(ExitCode::kDone);
} catch (const Error& error) {
    fmt::print(stderr, "cydonia: {}\n", printable(error.what()));
    return exit_code(error.code());
} catch (const Interrupted&) {
    fmt::print(stderr, "cydonia: interrupted; the same command goes on from here\n");
    return exit_code(ExitCode::kFailed);
} catch (const std::bad_alloc&) {
    fmt::print(stderr, "cydonia: out of memory; lower terrain.samples\n");
    return exit_code(ExitCode::kFailed);
} catch (const std::exception& error) {
    fmt::print(stderr, "cydonia: {}\n", error.what());
    return exit_code(ExitCode::kFailed);
}

}  // namespace

int main(int argc, char** argv) {
    catch_interrupts();
    CLI::App app;
    describe(app);
    Action action = [&app] { fmt::print("{}", app.help()); };
    add_commands(app, action);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        return app.exit(asked);  // --help, --version
    } catch (const CLI::ParseError& error) {
        return wrong_usage(app, error);
    }

    const int code = run(action);
    if (const int signal = interrupt_signal()) end_by(signal);
    return code;
}
