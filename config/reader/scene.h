#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "field/source.h"
#include "field/sun_path.h"
#include "render/options.h"
#include "synth/stage.h"

namespace cydonia::config {

struct TerrainSpec {
    double width = 5120.0, depth = 5120.0;  // metres, west to east and south to north
    int samples = 512;                      // along the longer side; cells are square
    int tiles = 0;  // made in parts of so many samples a side; 0: made whole
};

struct StageSpec {
    StageOptions options;
    std::string text;  // the stage's keys and values in canonical form, for cache keys
    std::vector<Source> sources;  // every file it names
};

// The frames of a sequence, and the video of them.
struct FramesSpec {
    static constexpr int kCount = 48;
    enum class Sweep { kDay };
    enum class Pace {
        kLingering,  // slow where the image appears, fast where it is far
        kEven,       // the same time from frame to frame
    };
    Sweep sweep = Sweep::kDay;
    std::optional<int> count;  // none: as many as the keys need, else 48
    double rate = 24.0;        // frames a second
    Pace pace = Pace::kLingering;
    double hold = 1.0;   // seconds that the video stands still on the image
    std::string camera;  // empty: the first that suits the sequence
    std::optional<GeographicPosition>
        place;                        // none: an arc through the first image's sun
    std::optional<Date> date;         // with a place
    std::optional<double> time_zone;  // hours ahead of UTC; none: by the longitude
};
inline constexpr int kMostFrames = 9999;

// A scene file as checked, typed values.
struct SceneSpec {
    std::string name;  // of the scene's folder or file: names the output folder
    std::string title;
    std::uint64_t seed = 1;
    TerrainSpec terrain;
    std::vector<StageSpec> stages;
    render::Options render;
    std::string render_text;  // canonical form of [render]
    FramesSpec frames;
    std::string frames_text;  // canonical form of [frames]

    std::vector<const StageOptions*> stage_options() const {
        std::vector<const StageOptions*> options;
        for (const StageSpec& stage : stages) options.push_back(&stage.options);
        return options;
    }
};

// What a scene file may contain, as JSON Schema (draft 7) for editors: every key that the
// readers name, with its type and range. Conditions between keys are not in it.
std::string scene_schema();

// A parsed scene file whose numbers may vary in time.
class Scene {
  public:
    // `overrides` are "terrain.samples=1024", as after --set. Throws one bad_request that
    // lists every mistake of the file as file:line:column: message.
    static Scene load(const std::filesystem::path& file,
                      const std::vector<std::string>& overrides = {});
    ~Scene();
    Scene(Scene&&) noexcept;

    // The scene at a frame, with values interpolated between keys and everything checked.
    SceneSpec at(double frame) const;

    bool varies() const;      // whether any value has keys
    double last_key() const;  // the last frame at which one has a key, at least 0

  private:
    struct Document;
    explicit Scene(std::unique_ptr<Document> document);
    std::unique_ptr<Document> document_;
};

}  // namespace cydonia::config
