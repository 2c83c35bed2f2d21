#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "field/source.h"
#include "render/options.h"
#include "synth/stage.h"

namespace cydonia::config {

struct TerrainSpec {
    double width = 5120.0, depth = 5120.0;  // metres, west to east and south to north
    int samples = 512;                      // along the longer side; cells are square
};

struct StageSpec {
    StageOptions options;
    std::string text;  // the stage's keys and values in canonical form, for cache keys
    std::vector<Source> sources;  // every file it names
};

// A scene file, typed and checked.
struct SceneSpec {
    std::string name;  // of the scene's folder or file: names the output folder
    std::string title;
    std::uint64_t seed = 1;
    TerrainSpec terrain;
    std::vector<StageSpec> stages;
    render::Options render;
    std::string render_text;  // canonical form of [render]
};

// A parsed scene file whose numbers may vary in time.
class Scene {
  public:
    // `overrides` are "terrain.samples=1024", as after --set. Throws one bad_request that
    // lists every mistake of the file as file:line:column: message.
    static Scene load(const std::filesystem::path& file,
                      const std::vector<std::string>& overrides = {});
    ~Scene();
    Scene(Scene&&) noexcept;

    // The scene at a frame: values with keys interpolated, everything checked.
    SceneSpec at(double frame) const;

  private:
    struct Document;
    explicit Scene(std::unique_ptr<Document> document);
    std::unique_ptr<Document> document_;
};

}  // namespace cydonia::config
