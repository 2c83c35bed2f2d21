#pragma once

#include <string>

#include "field/progress.h"

namespace cydonia::pareidolia {

// A line of text as an SVG drawing that fits its letters, with light ground around them,
// black on nothing. A warning says which font is used when the one asked for is not
// installed, and which letters it has not. Throws bad_request for text that is not UTF-8
// or holds control characters or nothing that draws.
struct Lettering {
    std::string svg;
    double width = 1.0, height = 1.0;  // its proportions, and the most pixels to draw
};
Lettering lettering(const std::string& text, const std::string& font, Progress& progress);

}  // namespace cydonia::pareidolia
