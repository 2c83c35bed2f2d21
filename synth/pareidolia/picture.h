#pragma once

#include <functional>
#include <string>

#include "field/field.h"
#include "field/progress.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// The picture that the shadow is to show. Its proportions are width : height.
struct Picture {
    std::string name;  // in messages
    double width = 1.0, height = 1.0;
    bool has_pixels = false;  // width x height of them, and no more detail
    // The lightness of the picture, 0 to 1, drawn with so many pixels (area average).
    // Below a half is shadow.
    std::function<Field<float>(int width, int height)> lightness;
};

// Reads a file as its options say, or draws a line of text. Throws bad_request.
Picture picture_of(const ImageOptions& options, Progress& progress);

}  // namespace cydonia::pareidolia
