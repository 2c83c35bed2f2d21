#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/pipeline/job.h"
#include "render/scene/shot.h"

namespace cydonia {

// A land as it is drawn, and the folder with POV-Ray's files of it. Both stay as long as
// somebody holds the site.
struct Site {
    std::shared_ptr<const Terrain> terrain;
    std::filesystem::path pov;
};

// Which land a frame draws.
struct FrameLand {
    Key key = 0;  // of the land as it is drawn
    // Makes the land when it is asked for. Any thread may ask.
    std::function<std::shared_ptr<const Site>()> site = {};
    // Its files are gone after the frame: all that is kept is the frame's own light.
    bool is_temporary = false;
};

// One frame and all that it draws, which need not be what the job begins with.
struct Frame {
    render::CameraOptions camera;  // its name is the frame's
    // Of its shutter: the frame is their mean. None: the camera as it stands.
    std::vector<render::CameraOptions> moments = {};
    // Where the camera is a frame later, for motion vectors; none: this is a still.
    std::optional<render::CameraOptions> next = {};
    std::string view = {};  // the scene's camera that it is seen by
    std::string when = {};  // "17:42 (UTC+2)"; empty in stills
    std::shared_ptr<const config::SceneSpec> scene = {};  // at this frame
    FrameLand land = {};
    // EV, one for all frames of a sequence; none: what this frame's own light asks for.
    std::optional<double> exposure = {};
    int threads = 1;               // of POV-Ray
    Progress* progress = nullptr;  // never null in use
};

// The job's own land, whose files are in pov/.
FrameLand land_of_stills(const Job& job);
Frame still_of(const Job& job, const render::CameraOptions& camera);
std::vector<Frame> stills_of(const Job& job);

// Every picture that POV-Ray draws for a frame: the camera's, or one a moment.
std::vector<render::CameraOptions> pictures_of(const Frame& frame);

// Adds what the frame draws besides its scene and land.
void add_to(KeyBuilder& key, const Frame& frame);

// What a camera sees of a land, resolved for whoever draws it.
render::Shot shot_of(const render::CameraOptions& camera, const config::SceneSpec& scene,
                     render::Quality quality, const Terrain& terrain);

}  // namespace cydonia
