#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/pipeline/land.h"
#include "app/pipeline/ledger.h"
#include "app/pipeline/step.h"
#include "app/request.h"
#include "config/reader/scene.h"
#include "field/image.h"

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
    std::vector<render::CameraOptions> cameras() const;  // asked for; at least one
    Metadata metadata() const;  // for the headers of what we write
};

// The steps of a job, in the order in which they are done.
std::vector<Step> stage_steps(Job& job);  // each after its explanation, if asked for
Step export_step(Job& job);
Step check_step(Job& job);
Step assets_step(Job& job);
Step shot_step(Job& job, const render::CameraOptions& camera);
std::vector<Step> frame_steps(Job& job, const render::CameraOptions& camera);

// A frame is traced from what these steps wrote.
inline constexpr const char* kAssetsStep = "emit land";
std::string shot_step_name(const std::string& frame);

// Every step of the scene, whatever the goal.
std::vector<Step> steps_of(Job& job);

}  // namespace cydonia
