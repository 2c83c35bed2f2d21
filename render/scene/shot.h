#pragma once

#include <string>

#include "field/camera.h"
#include "field/rgb.h"
#include "field/sun.h"
#include "field/terrain.h"
#include "render/options.h"

namespace cydonia::render {

// Everything that one frame shows, with all defaults resolved.
struct Shot {
    std::string title;  // for a comment in the .pov; any bytes
    std::string
        name;  // is_shot_name (render/scene/files.h); its files are named after it
    Camera camera;
    Sun sun;
    Options options;
    Quality quality = Quality::kPreview;
    Around around = Around::kLevel;
    bool smooth = false;  // is_smooth (render/cameras/view.h)
};

// Whether haze is drawn. A map from above has none, as it would only veil the land.
bool has_haze(const Shot& shot);
// The colour of the haze in the direction of the shot's camera, linear Rec.709.
Rgb haze_light(const Shot& shot);

}  // namespace cydonia::render
