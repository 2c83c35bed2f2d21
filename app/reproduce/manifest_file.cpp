#include "app/reproduce/manifest_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "app/pipeline/manifest.h"
#include "app/request_json.h"
#include "field/error.h"
#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr std::size_t kMostOutputs = 1'000'000;

// Accepts paths below the folder; no other file is read or compared.
std::string below(const std::string& file) {
    const fs::path path(file);
    if (path.empty() || path.is_absolute() || std::ranges::find(path, "..") != path.end())
        throw bad_request("outputs: '{}' leaves the manifest's folder", file);
    return file;
}

int threads_of(const Json& json) {
    const int threads = json.at("timings").at("threads").get<int>();
    if (threads < 0 || threads > 1024)
        throw bad_request("timings.threads: {} is not between 0 and 1024", threads);
    return threads;
}

void read_outputs(const Json& outputs, ManifestFile& manifest) {
    if (outputs.size() > kMostOutputs)
        throw bad_request("outputs: {} are more than {}", outputs.size(), kMostOutputs);
    for (const Json& output : outputs)
        manifest.outputs.push_back({below(output.at("file")), output.at("xxh3")});
}

// How an input has changed; empty if it has not.
std::string change_of(const Json& input, const fs::path& folder) {
    const fs::path path = (folder / input.at("path").get<std::string>());
    try {
        const Source now = open_source(path);
        if (hex(now.hash) == input.at("xxh3")) return "";
        return fmt::format("{} has changed since: xxh3 {} then, {} now", path.string(),
                           input.at("xxh3").get<std::string>(), hex(now.hash));
    } catch (const Error& error) {
        return error.what();
    }
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

// Adds the first line of the canonical text that the scene reads differently now.
void compare_text(const Json& then, const Json& now, const std::string& where,
                  std::vector<std::string>& changes) {
    if (then == now) return;
    const auto before = lines_of(then.get<std::string>());
    for (const std::string& line : lines_of(now.get<std::string>()))
        if (std::ranges::find(before, line) == before.end()) {
            changes.push_back(fmt::format("{}: {} was different then", where, line));
            return;
        }
    changes.push_back(fmt::format("{}: has fewer keys than then", where));
}

void compare_options(const Json& then, const Json& now,
                     std::vector<std::string>& changes) {
    for (const char* key : {"extent", "samples", "tiles"})
        if (then.at(key) != now.at(key))
            changes.push_back(fmt::format("terrain.{}: {} then, {} now", key,
                                          then.at(key).dump(), now.at(key).dump()));
    for (const char* key : {"render", "frames"})
        compare_text(then.at(key), now.at(key), key, changes);
    if (then.at("stages").size() != now.at("stages").size()) {
        changes.push_back("the number of stages is not what it was then");
        return;
    }
    for (std::size_t i = 0; i < now.at("stages").size(); ++i)
        compare_text(then.at("stages").at(i).at("text"),
                     now.at("stages").at(i).at("text"),
                     fmt::format("terrain.stage[{}]", i), changes);
}

}  // namespace

ManifestFile read_manifest(const fs::path& file) try {
    ManifestFile manifest;
    if (!fs::is_regular_file(file)) throw bad_request("no such file");
    manifest.folder = fs::absolute(file).lexically_normal().parent_path();
    manifest.json = Json::parse(read_text(file));
    const Json& json = manifest.json;
    if (!json.contains("manifest")) throw bad_request("not a manifest of Cydonia");
    if (json.at("manifest") != kManifestVersion)
        throw bad_request(
            "a manifest of version {}; this cydonia {} reads version {}: make the scene "
            "again with this one, or take the cydonia {} that wrote it",
            json.at("manifest").dump(), kVersion, kManifestVersion,
            json.at("versions").at("cydonia").get<std::string>());
    Command command = command_of(json.at("command"));
    manifest.goals = std::move(command.goals);
    manifest.request = std::move(command.request);
    manifest.request.force = true;  // a check that fell short will do so again
    manifest.request.scene =
        (manifest.folder / json.at("inputs").at("scene").at("path").get<std::string>())
            .lexically_normal();
    manifest.request.threads = threads_of(json);
    read_outputs(json.at("outputs"), manifest);
    return manifest;
} catch (const Json::exception&) {
    throw bad_request("{}: not a manifest of Cydonia", file.string());
} catch (const Error& error) {
    throw bad_request("{}: {}", file.string(), error.what());
}

std::vector<std::string> check_inputs(const ManifestFile& manifest) try {
    const Json& inputs = manifest.json.at("inputs");
    std::vector<std::string> changes;
    const auto check = [&](const Json& input) {
        if (std::string change = change_of(input, manifest.folder); !change.empty())
            changes.push_back(std::move(change));
    };
    check(inputs.at("scene"));
    for (const Json& input : inputs.at("files")) check(input);
    if (changes.empty()) {
        const auto scene =
            config::Scene::load(manifest.request.scene, manifest.request.overrides);
        compare_options(manifest.json.at("options"), options_of(scene.at(0.0)), changes);
    }
    if (!changes.empty())
        throw bad_request("the scene is not what it was made from:\n  {}",
                          fmt::join(changes, "\n  "));

    std::vector<std::string> notes;
    const Json& versions = manifest.json.at("versions");
    if (versions.at("cydonia") != kVersion)
        notes.push_back(fmt::format("made by cydonia {}; this is {}",
                                    versions.at("cydonia").get<std::string>(), kVersion));
    else if (versions.at("program") != hex(open_source("/proc/self/exe").hash))
        notes.push_back("made by another build of this version");
    return notes;
} catch (const Json::exception&) {
    throw bad_request("{}: not a manifest of Cydonia",
                      (manifest.folder / "manifest.json").string());
}

}  // namespace cydonia
