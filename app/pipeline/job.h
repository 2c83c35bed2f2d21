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

// A request for one scene and everything that follows from it. A job does not change;
// what has been done so far is in the Ledger of its folder.
struct Job {
    Job(const Request& request, Progress& progress);

    const Request request;
    const Source scene_file;
    const config::Scene scene;
    const std::shared_ptr<const config::SceneSpec> spec;  // the scene at frame 0
    const std::filesystem::path folder;                   // the output folder
    const LandStore land;
    Progress& progress;
    const std::uint64_t program;  // a hash of this program's file

    std::uint64_t cells() const;
    std::uint64_t drawn_cells() const;  // of the land as it is drawn
    // The scene's cameras, else the default ones; at least one.
    std::vector<render::CameraOptions> cameras() const;
    // Sets the camera's size so that its frame, of which drafts and previews draw a
    // share, gets the size asked for on the command line.
    void resize(render::CameraOptions& camera) const;
    // The scene at a frame, with the request's sizes.
    config::SceneSpec at(double frame) const;
    // The terrains of a scene at a frame.
    LandStore land_of(std::shared_ptr<const config::SceneSpec> then,
                      Progress& progress) const;
    Metadata metadata() const;  // for the headers of what we write
};

// The output folder of a request: -o, else out/<scene>.
std::filesystem::path output_of(const Request& request);

// Pixels of the camera's frame at final quality; other qualities have fewer.
std::uint64_t pixels_of(const render::CameraOptions& camera);
std::uint64_t most_pixels(const Job& job);  // of all its cameras

}  // namespace cydonia
