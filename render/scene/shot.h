#pragma once

#include <string>

#include "field/camera.h"
#include "field/rgb.h"
#include "field/sun.h"
#include "field/terrain.h"
#include "render/options.h"

namespace cydonia::render {

// One frame to be drawn: everything the .pov says, resolved.
struct Shot {
    std::string title;  // for the comment at the top; any bytes
    std::string name;   // file-name-safe; the .pov and the frame are called after it
    Camera camera;
    Sun sun;
    Options options;
    Quality quality = Quality::kPreview;
    Around around = Around::kLevel;
    bool smooth = false;  // is_smooth (render/cameras/view.h)
};

// Whether haze is drawn: a map has none, it would only veil.
bool has_haze(const Shot& shot);
// What the haze sends back as far as the shot's camera looks, linear Rec.709.
Rgb haze_light(const Shot& shot);

}  // namespace cydonia::render
