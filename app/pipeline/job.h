#pragma once

#include <filesystem>
#include <functional>
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
    config::SceneSpec spec;
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
    Metadata metadata() const;  // for the headers of what we write
};

// What sets a frame of a sequence apart from a still of the same camera.
struct FrameOf {
    std::string camera = {};       // whose view it is, for the metadata; empty: its own
    std::string when = {};         // likewise; empty: nothing to say
    int threads = 0;               // of POV-Ray; 0: all
    Progress* progress = nullptr;  // null: the job's
    std::function<double()> exposure = {};  // EV for the whole sequence; empty: its own
};

// The steps of a job, in the order in which they are done.
std::vector<Step> stage_steps(Job& job);  // each after its explanation, if asked for
Step export_step(Job& job);
Step solid_step(Job& job);  // of a request for one
Step check_step(Job& job);
Step assets_step(Job& job);
Step shot_step(Job& job, const render::CameraOptions& camera, const FrameOf& of = {});
// The trace and the delivery.
std::vector<Step> frame_steps(Job& job, const render::CameraOptions& camera,
                              const FrameOf& of = {});

// In place of shot and frame, of a request for a preview.
Step preview_step(Job& job, const render::CameraOptions& camera);
// After the frame, of a scene that asks for passes.
Step passes_step(Job& job, const render::CameraOptions& camera);

// A frame is traced from what these steps wrote.
inline constexpr const char* kAssetsStep = "emit land";
std::string shot_step_name(const std::string& frame);
// What the camera draws of the finished land.
render::Shot shot_of(const render::CameraOptions& camera, const Job& job,
                     const Terrain& terrain);
std::uint64_t ocio_hash();  // of the config that $OCIO names, 0 for none

// Every step of the scene, whatever the goal.
std::vector<Step> steps_of(Job& job);

}  // namespace cydonia
