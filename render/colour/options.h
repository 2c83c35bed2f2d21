#pragma once

#include <optional>
#include <string>

#include "field/source.h"

namespace cydonia::render {

struct ColourOptions {
    std::optional<Source> config;  // default: $OCIO, else the shipped config
    std::string display;           // default: the config's
    std::string view;
    // EV above or below what each frame gets by itself: its 90th percentile of light
    // shown as 0.5 of white before the view, six stops up or down at most. The EXR has
    // none of it.
    double exposure = 0.0;
};

}  // namespace cydonia::render
