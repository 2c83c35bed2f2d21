#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/pipeline/land.h"
#include "app/pipeline/ledger.h"
#include "app/pipeline/step.h"
#include "app/request.h"
#include "config/reader/scene.h"
#include "field/image.h"
#include "render/pov/scene.h"

namespace cydonia {

inline constexpr const char* kVersion = CYDONIA_VERSION;

// One scene on its way to frames.
struct Job {
    Job(const Request& request, Progress& progress);

    Request request;
    Source scene_file;
    config::Scene scene;
    config::SceneSpec spec;        // the scene at frame 0
    std::filesystem::path folder;  // where everything goes
    Land land;
    Ledger ledger;
    Progress& progress;
    std::uint64_t program;  // a hash of this very program

    std::uint64_t cells() const {
        return static_cast<std::uint64_t>(land.width()) *
               static_cast<std::uint64_t>(land.height());
    }
    // Of the land as drawn.
    std::uint64_t drawn_cells() const {
        const auto factor = static_cast<std::uint64_t>(land.factor());
        return factor * factor * cells();
    }
    std::vector<render::CameraOptions> cameras() const;  // asked for; at least one
    // So that with the quality's share of it its frame is as large as asked for.
    void resize(render::CameraOptions& camera) const;
    // The scene at a frame, as it was asked for.
    config::SceneSpec at(double frame) const;
    // Its land, which refers to it.
    Land land_of(const config::SceneSpec& then, Progress& progress) const;
    Metadata metadata() const;  // for the headers of what we write
};

// Where what is asked for goes: -o, else out/<scene>.
std::filesystem::path output_of(const Request& request);

// A land to be drawn, and the folder of POV-Ray's files of it.
struct Site {
    const Terrain& terrain;
    std::filesystem::path pov;
};

// What sets a frame of a sequence apart from a still of the same camera.
struct FrameOf {
    std::string camera = {};       // whose view it is, for the metadata; empty: its own
    std::string when = {};         // likewise; empty: nothing to say
    int threads = 0;               // of POV-Ray; 0: all
    Progress* progress = nullptr;  // null: the job's
    std::optional<double> exposure = {};       // EV for the whole sequence; none: its own
    const config::SceneSpec* scene = nullptr;  // at that frame; null: the job's
    // The moments of its shutter, in whose mean it moves; none: the camera as it is.
    std::vector<render::CameraOptions> moments = {};
    // A land that is not the job's; empty: the job's. Asked when a step needs it.
    std::function<std::shared_ptr<const Site>()> site = {};
    std::uint64_t land = 0;  // the key of that
};

// The steps of a job, in the order in which they are done.
std::vector<Step> stage_steps(Job& job);  // each after its explanation, if asked for
Step export_step(Job& job);
Step check_step(Job& job);
Step assets_step(Job& job);
Step shot_step(Job& job, const render::CameraOptions& camera, const FrameOf& of = {});
// The trace and the delivery.
std::vector<Step> frame_steps(Job& job, const render::CameraOptions& camera,
                              const FrameOf& of = {});

// In place of shot and frame, of a request for a preview: one a camera.
std::vector<Step> preview_steps(Job& job);
// After the frame, of a scene that asks for passes; with `next`, where the camera is a
// frame later, they have motion.
Step passes_step(Job& job, const render::CameraOptions& camera, const FrameOf& of = {},
                 const std::optional<render::CameraOptions>& next = {});

// A frame is traced from what these steps wrote.
inline constexpr const char* kAssetsStep = "emit land";
std::string shot_step_name(const std::string& frame);
// What the camera draws of the land of `scene`, which may be the job's own.
render::Shot shot_of(const render::CameraOptions& camera, const Job& job,
                     const config::SceneSpec& scene, const Terrain& terrain);
// The job's own land and pov folder, or what the frame says instead.
std::shared_ptr<const Site> site_of(Job& job, const FrameOf& of);
const config::SceneSpec& scene_of(const Job& job, const FrameOf& of);
// What a frame draws besides its scene and land.
std::string text_of(const render::CameraOptions& camera, const FrameOf& of);
// Every picture that POV-Ray draws for a frame: the camera's, or one a moment.
std::vector<render::CameraOptions> pictures_of(const render::CameraOptions& camera,
                                               const FrameOf& of);
// Writes their scenes beside the land's files; gives the names of the files.
Made write_pictures(const Job& job, const Site& site, const render::CameraOptions& camera,
                    const FrameOf& of);
// A frame of a land of its own, whose files are not kept: pov/<frame>.exr.
Step trace_step_at_site(Job& job, const render::CameraOptions& camera, const FrameOf& of);
Step deliver_step(Job& job, const render::CameraOptions& camera, const FrameOf& of);
std::uint64_t ocio_hash();  // of the config that $OCIO names, 0 for none

// Every step of the scene, whatever the goal.
std::vector<Step> steps_of(Job& job);

}  // namespace cydonia
