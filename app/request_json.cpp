#include "app/request_json.h"

#include <string>
#include <vector>

#include "config/reader/scene.h"
#include "field/error.h"

namespace cydonia {
namespace {

// The value of `all` with this name.
template <class T>
T named(const std::string& name, const std::vector<T>& all, const char* what) {
    for (const T& one : all)
        if (name_of(one) == name) return one;
    throw bad_request("command.{}: '{}' is not known to this version", what, name);
}

int within(const Json& json, const char* name, int low, int high) {
    const int value = json.get<int>();
    if (value < low || value > high)
        throw bad_request("command.{}: {} is not between {} and {}", name, value, low,
                          high);
    return value;
}

Json json_of(const ExportRequest& asked) {
    Json json = {{"to", name_of(asked.format)},
                 {"size", asked.solid.size},
                 {"base", asked.solid.base},
                 {"scale_z", asked.solid.scale_z}};
    if (asked.samples) json["samples"] = *asked.samples;
    return json;
}

ExportRequest export_of(const Json& json) {
    const std::string to = json.at("to");
    const auto found = export_formats().find(to);
    if (found == export_formats().end())
        throw bad_request("command.export.to: '{}' is not known to this version", to);
    ExportRequest asked{.format = found->second};
    asked.solid.size = json.at("size");
    asked.solid.base = json.at("base");
    asked.solid.scale_z = json.at("scale_z");
    if (json.contains("samples")) asked.samples = json.at("samples").get<int>();
    return asked;
}

}  // namespace

std::string_view name_of(Goal goal) {
    constexpr std::string_view kNames[] = {"synth",  "check", "report",    "emit",
                                           "render", "sweep", "turntable", "film"};
    return kNames[static_cast<int>(goal)];
}

Json json_of(const Command& command) {
    const Request& request = command.request;
    Json json = {{"goals", Json::array()},
                 {"quality", name_of(request.quality)},
                 {"set", request.overrides}};
    for (const Goal goal : command.goals) json["goals"].push_back(name_of(goal));
    if (request.size) json["size"] = *request.size;
    if (request.frames) json["frames"] = {request.frames->first, request.frames->last};
    if (request.preview) json["style"] = name_of(*request.preview);
    if (request.explain) json["explain"] = true;
    if (request.first_camera_only) json["first_camera_only"] = true;
    if (request.export_as) json["export"] = json_of(*request.export_as);
    return json;
}

Command command_of(const Json& json) {
    Command command;
    for (const std::string goal : json.at("goals"))
        command.goals.push_back(
            named(goal,
                  std::vector{Goal::kTerrain, Goal::kCheck, Goal::kEmit, Goal::kFrames,
                              Goal::kSweep, Goal::kTurntable, Goal::kFilm},
                  "goals"));
    Request& request = command.request;
    request.quality = named(json.at("quality").get<std::string>(),
                            values_in(render::kQualities), "quality");
    request.overrides = json.at("set").get<std::vector<std::string>>();
    if (json.contains("size")) {
        const Json& size = json.at("size");
        request.size = {within(size.at(0), "size", 16, 16384),
                        within(size.at(1), "size", 16, 16384)};
    }
    if (json.contains("frames")) {
        const int first =
            within(json.at("frames").at(0), "frames", 0, config::kMostFrames - 1);
        const int last =
            within(json.at("frames").at(1), "frames", first, config::kMostFrames - 1);
        request.frames = {first, last};
    }
    if (json.contains("style"))
        request.preview = named(json.at("style").get<std::string>(),
                                values_in(render::kStyles), "style");
    request.explain = json.value("explain", false);
    request.first_camera_only = json.value("first_camera_only", false);
    if (json.contains("export")) request.export_as = export_of(json.at("export"));
    return command;
}

}  // namespace cydonia
