#pragma once

#include <functional>
#include <string>

#include "field/field.h"
#include "field/progress.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// What the user gave to be the shadow: a picture whose proportions are width : height.
struct Picture {
    std::string name;  // in messages
    double width = 1.0, height = 1.0;
    bool has_pixels = false;  // width x height of them, and no more detail
    // How light it is, 0 to 1, drawn with so many pixels (area average): less than a half
    // is shadow.
    std::function<Field<float>(int width, int height)> lightness;
};

// A file read as its options say, or a line of text. Throws bad_request.
Picture picture_of(const ImageOptions& options, Progress& progress);

}  // namespace cydonia::pareidolia
