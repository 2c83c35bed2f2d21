#include "config/reader/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/reader/overrides.h"
#include "config/reader/parse.h"
#include "config/reader/readers.h"
#include "field/error.h"
#include "field/file_names.h"
#include "field/files.h"

namespace cydonia::config {
namespace fs = std::filesystem;

struct Scene::Document {
    Origins origins;
    std::string name;
    Value root;
    Files files;
    std::set<double> key_frames = {};
};

namespace {

constexpr std::size_t kMostBytes = 1u << 20;
constexpr std::size_t kMostKeyFrames = 4096;

// scenes/text/scene.toml is called text, scenes/foo.toml foo.
std::string scene_name(const fs::path& file) {
    const bool in_folder = file.filename() == "scene.toml";
    const std::string name =
        in_folder
            ? fs::absolute(file).lexically_normal().parent_path().filename().string()
            : file.stem().string();
    const bool is_plain =
        !name.empty() && name.size() <= 64 &&
        std::ranges::all_of(name, [](unsigned char c) {
            return (c < 0x80 && std::isalnum(c)) || c == '_' || c == '-';
        });
    if (is_plain) return name;
    return name.empty() ? "scene" : file_name_of(name);
}

void read(Table& t, SceneSpec& scene) {
    t.field("title", scene.title, Text{});
    t.field("seed", scene.seed, Whole{0, std::numeric_limits<std::int64_t>::max()});
    TerrainTable terrain{scene.terrain, scene.stages};
    t.table("terrain", terrain);
    RenderTable render{scene.render, scene.render_text};
    t.table("render", render);
    FramesTable frames{scene.frames, scene.frames_text};
    t.table("frames", frames, scene.render.cameras);
}

SceneSpec read_scene(const Value& root, Reading& reading, const std::string& name) {
    SceneSpec scene;
    scene.name = scene.title = name;
    Table table(reading, &root, root.at);
    read(table, scene);
    table.report_unknown();
    return scene;
}

void throw_mistakes(std::vector<Mistake> mistakes, const Origins& origins) {
    if (!mistakes.empty()) throw bad_request("{}", listed(std::move(mistakes), origins));
}

}  // namespace

std::string scene_schema() {
    Files files("");
    Reading reading{files};
    reading.describes = true;
    Table table(reading, nullptr, {});
    SceneSpec scene;
    read(table, scene);
    std::string schema = table.schema();
    schema.insert(1, R"("$schema":"http://json-schema.org/draft-07/schema#",)"
                     R"("title":"A scene of Cydonia",)");
    return schema;
}

Scene::Scene(std::unique_ptr<Document> document) : document_(std::move(document)) {}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;

Scene Scene::load(const fs::path& file, const std::vector<std::string>& overrides) {
    const Origins origins{file.string(), overrides};
    Value root = parse(read_text(file, kMostBytes), origins.file);

    std::vector<Mistake> mistakes;
    for (std::size_t i = 0; i < overrides.size(); ++i)
        if (auto wrong = apply_override(root, overrides[i], static_cast<int>(i) + 1))
            mistakes.push_back(std::move(*wrong));

    auto document = std::make_unique<Document>(
        Document{origins, scene_name(file), std::move(root), Files(file.parent_path())});
    Reading reading{document->files};
    read_scene(document->root, reading, document->name);
    std::ranges::move(reading.mistakes, std::back_inserter(mistakes));
    throw_mistakes(std::move(mistakes), origins);

    // Values are linear between keys, and so are the differences that checks compare. A
    // check that holds at every key therefore holds at every frame.
    if (reading.key_frames.size() > kMostKeyFrames)
        throw bad_request("{}: keys at {} frames are too many; at most {}", origins.file,
                          reading.key_frames.size(), kMostKeyFrames);
    document->key_frames = std::move(reading.key_frames);
    Scene scene(std::move(document));
    for (const double frame : scene.document_->key_frames) scene.at(frame);
    return scene;
}

bool Scene::varies() const { return !document_->key_frames.empty(); }

double Scene::last_key() const {
    return varies() ? std::max(0.0, *document_->key_frames.rbegin()) : 0.0;
}

SceneSpec Scene::at(double frame) const {
    if (!std::isfinite(frame)) throw bad_request("frame {} is not a number", frame);
    Reading reading{document_->files, frame, true};
    SceneSpec scene = read_scene(document_->root, reading, document_->name);
    for (auto& mistake : reading.mistakes)
        mistake.message += fmt::format(" (at frame {})", frame);
    throw_mistakes(std::move(reading.mistakes), document_->origins);
    return scene;
}

}  // namespace cydonia::config
