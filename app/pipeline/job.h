#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/pipeline/key.h"
#include "app/pipeline/land_store.h"
#include "app/request.h"
#include "config/reader/scene.h"
#include "field/image.h"

namespace cydonia {

inline constexpr const char* kVersion = CYDONIA_VERSION;

// One scene on its way to frames: what was asked for and what follows from that. It does
// not change; what has been done so far is in the folder's Ledger.
struct Job {
    Job(const Request& request, Progress& progress);

    const Request request;
    const Source scene_file;
    const config::Scene scene;
    const std::shared_ptr<const config::SceneSpec> spec;  // the scene at frame 0
    const std::filesystem::path folder;                   // where everything goes
    const LandStore land;
    Progress& progress;
    const std::uint64_t program;  // a hash of this very program

    std::uint64_t cells() const;
    std::uint64_t drawn_cells() const;  // of the land as it is drawn
    // Asked for; at least one.
    std::vector<render::CameraOptions> cameras() const;
    // Gives the camera the size asked for on the command line, so that the share of it
    // that the quality draws is as large.
    void resize(render::CameraOptions& camera) const;
    // The scene at a frame, as it was asked for.
    config::SceneSpec at(double frame) const;
    // The terrains of such a scene.
    LandStore land_of(std::shared_ptr<const config::SceneSpec> then,
                      Progress& progress) const;
    Metadata metadata() const;  // for the headers of what we write
};

// Where what is asked for goes: -o, else out/<scene>.
std::filesystem::path output_of(const Request& request);

// Pixels of the camera's frame at final quality, the most there are.
std::uint64_t pixels_of(const render::CameraOptions& camera);
std::uint64_t most_pixels(const Job& job);  // of all its cameras

}  // namespace cydonia
