#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/pipeline/job.h"
#include "render/scene/land_maps.h"
#include "render/scene/shot.h"

namespace cydonia {

// A land as it is drawn, with its maps, and the folder with POV-Ray's files for it. All
// exist as long as somebody holds the site.
struct Site {
    std::shared_ptr<const Terrain> terrain;
    // Without the albedo. Any thread may call it.
    std::function<std::shared_ptr<const render::LandMaps>()> maps;
    std::filesystem::path pov;
};

// Which land a frame draws.
struct FrameLand {
    Key key = 0;  // of the land as it is drawn
    // Makes the land when it is first called. Any thread may call it.
    std::function<std::shared_ptr<const Site>()> site = {};
    // Its files are removed after the last frame that draws it; only the light is kept.
    bool is_temporary = false;
};

// One frame with everything that it draws, which in films varies from frame to frame.
struct Frame {
    render::CameraOptions camera;  // its name is the frame's
    // The camera at moments while the shutter is open; the frame is the mean of their
    // pictures. Empty: one picture by `camera`.
    std::vector<render::CameraOptions> moments = {};
    // The camera one frame later, for motion vectors; none: a still.
    std::optional<render::CameraOptions> next = {};
    std::string view = {};  // the name of the scene's camera
    std::string when = {};  // the time of day, "17:42 (UTC+2)"; may be empty
    std::shared_ptr<const config::SceneSpec> scene = {};  // at this frame
    FrameLand land = {};
    // EV, the same for all frames of a sequence; none: chosen from the frame's own light.
    std::optional<double> exposure = {};
    int threads = 1;               // of POV-Ray
    Progress* progress = nullptr;  // not null when steps are made of it
};

// The job's own land, whose files stay in pov/.
FrameLand land_of_stills(const Job& job);
Frame still_of(const Job& job, const render::CameraOptions& camera);
std::vector<Frame> stills_of(const Job& job);

// The cameras of the pictures that POV-Ray draws for a frame: one, or one a moment.
std::vector<render::CameraOptions> pictures_of(const Frame& frame);

// Adds everything of the frame but its scene, land and exposure.
void add_to(KeyBuilder& key, const Frame& frame);

// Everything about a view of a land, resolved for whoever draws it.
render::Shot shot_of(const render::CameraOptions& camera, const config::SceneSpec& scene,
                     render::Quality quality, const Terrain& terrain);

}  // namespace cydonia
