#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/commands/commands.h"
#include "app/manual.h"
#include "config/reader/mistakes.h"
#include "config/reader/scene.h"
#include "field/data.h"
#include "field/error.h"
#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

struct NewScene {
    fs::path folder;
    std::string from;  // empty: "text", or "horse" with a picture
    fs::path picture;  // empty: the example's own
};

std::vector<std::string> examples() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(data_folder("scenes")))
        if (fs::exists(entry.path() / "scene.toml"))
            names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

fs::path example(const std::string& name) {
    const std::vector<std::string> known = examples();
    if (std::ranges::find(known, name) == known.end()) {
        const std::string meant = config::suggestion(name, known);
        throw bad_request("no example scene '{}'{}", name,
                          meant.empty()
                              ? fmt::format("; there are {}", fmt::join(known, ", "))
                              : meant);
    }
    return data_folder("scenes") / name;
}

bool is_picture(const fs::path& file) {
    constexpr std::string_view kExtensions[] = {".png",  ".jpg", ".jpeg", ".tif",
                                                ".tiff", ".exr", ".svg"};
    std::error_code none;
    return fs::is_regular_file(file, none) &&
           std::ranges::find(kExtensions, file.extension().string()) !=
               std::end(kExtensions);
}

// Puts the picture's name in place of the value of every line `target = "..."`. Adds the
// values that were there to `others`, which begins with scene.toml.
std::string with_target(const std::string& scene, const std::string& picture,
                        std::vector<std::string>& others) {
    constexpr std::string_view kKey = "target = \"";
    std::string text;
    for (std::size_t begin = 0; begin < scene.size();) {
        const std::size_t end = std::min(scene.find('\n', begin), scene.size());
        const std::string line = scene.substr(begin, end - begin);
        const std::size_t close = line.find('"', kKey.size());
        if (line.starts_with(kKey) && close != line.npos) {
            others.push_back(line.substr(kKey.size(), close - kKey.size()));
            text += std::string(kKey) + picture + line.substr(close);
        } else {
            text += line;
        }
        text += '\n';
        begin = end + 1;
    }
    if (others.size() < 2)
        throw bad_request("that example shows no picture; take --from horse");
    return text;
}

// Examples share files in a folder beside them; a copy has them inside.
std::vector<fs::path> take_inside(std::string& text, const fs::path& source) {
    std::vector<fs::path> files;
    const config::SceneSpec scene = config::Scene::load(source / "scene.toml").at(0.0);
    for (const config::StageSpec& stage : scene.stages)
        for (const Source& file : stage.sources) {
            const fs::path path = fs::canonical(file.path);
            const std::string there =
                '"' + path.lexically_relative(source).string() + '"';
            const std::string here = '"' + path.filename().string() + '"';
            if (!there.starts_with("\"..")) continue;
            for (auto at = text.find(there); at != text.npos; at = text.find(there)) {
                text.replace(at, there.size(), here);
                files.push_back(path);
            }
        }
    return files;
}

void make_new(const NewScene& request) {
    const bool has_picture = !request.picture.empty();
    const std::string from =
        !request.from.empty() ? request.from : (has_picture ? "horse" : "text");
    const fs::path source = fs::canonical(example(from)),
                   scene = request.folder / "scene.toml";
    std::error_code none;
    if (fs::exists(request.folder, none) && !fs::is_empty(request.folder, none))
        throw bad_request("{} exists; choose another name", request.folder.string());
    std::string text = read_text(source / "scene.toml");
    std::vector<std::string> left_out{"scene.toml"};
    const std::string picture = "picture" + request.picture.extension().string();
    if (has_picture) {
        if (!is_picture(request.picture))
            throw bad_request("'{}' is no PNG, JPEG, TIFF, EXR or SVG that can be read",
                              request.picture.string());
        text = with_target(text, picture, left_out);
    }

    const std::vector<fs::path> shared = take_inside(text, source);

    make_folder(request.folder);
    for (const fs::path& file : shared)
        fs::copy_file(file, request.folder / file.filename(),
                      fs::copy_options::skip_existing);
    for (const auto& entry : fs::directory_iterator(source))
        if (entry.is_regular_file() &&
            std::ranges::find(left_out, entry.path().filename().string()) ==
                left_out.end())
            fs::copy_file(entry.path(), request.folder / entry.path().filename());
    if (has_picture) fs::copy_file(request.picture, request.folder / picture);
    write_text(scene, commented(text, Manual::load()));
    config::Scene::load(scene);  // throws if something is wrong with the picture
    fmt::print(
        "{0} begins as a copy of '{1}'; next:\n"
        "  cydonia render {0} --quality draft\n",
        scene.string(), from);
    if (has_picture) fmt::print("  cydonia sweep {} --quality draft\n", scene.string());
}

}  // namespace

void add_new(CLI::App& app, Action& action) {
    const auto request = std::make_shared<NewScene>();
    CLI::App* command = add_command(app, {"new", "Begin a scene from an example",
                                          "new my-mountain --picture cat.png"});
    command->add_option("FOLDER", request->folder, "to be made")
        ->required()
        ->type_name("");
    command->add_option("--from", request->from, "an example in scenes/ [text]")
        ->type_name("NAME");
    command
        ->add_option("--picture", request->picture,
                     "a PNG or SVG, black on white, for the shadows to show")
        ->type_name("FILE");
    command->callback([request, &action] { action = [request] { make_new(*request); }; });
}

}  // namespace cydonia
