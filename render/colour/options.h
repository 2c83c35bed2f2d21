#pragma once

#include <optional>
#include <string>

#include "field/source.h"

namespace cydonia::render {

struct ColourOptions {
    std::optional<Source> config;  // default: $OCIO, else the shipped config
    std::string display;           // default: the config's
    std::string view;
    // EV, added to the exposure of each frame's own (exposure.h). The EXR is not exposed.
    double exposure = 0.0;
};

}  // namespace cydonia::render
