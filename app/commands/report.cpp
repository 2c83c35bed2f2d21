#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/pipeline/job.h"
#include "app/pipeline/pipeline.h"
#include "app/request_json.h"
#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

// The request with the options of the last run, whose files the page shows.
Request as_made(Request request) {
    std::error_code none;
    const fs::path manifest = output_of(request) / "manifest.json";
    if (!fs::is_regular_file(manifest, none)) return request;
    try {
        const Json json = Json::parse(read_text(manifest));
        const Request made = command_of(json.at("command")).request;
        request.quality = made.quality;
        request.size = made.size;
        request.preview = made.preview;
        request.overrides = made.overrides;
    } catch (const std::exception&) {
        // The manifest is of another version: it counts as missing.
    }
    return request;
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    CLI::App* command = add_command(
        app, {"report", "Show all there is of a scene on one page",
              "report scenes/text/scene.toml && xdg-open out/text/report.html"});
    add_scene(*command, *request)->required();
    add_making_options(*command, *request);
    command->callback([request, command, &action] {
        const bool as_before = command->get_option("--quality")->count() == 0 &&
                               command->get_option("--set")->count() == 0;
        action = [request, as_before] {
            Console console(style_for_stderr(request->quiet));
            make(as_before ? as_made(*request) : *request, Goal::kReport, console);
        };
    });
}

}  // namespace cydonia
