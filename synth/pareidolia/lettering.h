#pragma once

#include <string>

#include "field/progress.h"

namespace cydonia::pareidolia {

// A line of text as an SVG drawing that fits its letters: black on transparent ground,
// with a margin. A warning says which font is used when the requested one is not
// installed, and which letters the font lacks. Throws bad_request for text that is not
// UTF-8, contains control characters or has nothing visible.
struct Lettering {
    std::string svg;
    double width = 1.0, height = 1.0;  // its proportions, and the most pixels to draw
};
Lettering lettering(const std::string& text, const std::string& font, Progress& progress);

}  // namespace cydonia::pareidolia
