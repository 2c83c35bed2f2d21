#pragma once

#include "field/field.h"
#include "synth/pareidolia/options.h"
#include "synth/pareidolia/picture.h"

namespace cydonia::pareidolia {

// The picture's rectangle on a grid of width x height cells, in cells from the grid's
// north-west corner, where y grows south.
struct Frame {
    double x = 0.0, y = 0.0;           // of its middle
    double width = 0.0, height = 0.0;  // before it is turned
    double rotation = 0.0;             // radians, clockwise seen from above
};
Frame frame_of(const Picture& picture, const Placing& placing, int width, int height);

// The lightness of every cell: the mean over its square, and 1 beyond the picture. A
// picture that covers the whole grid is only resized.
Field<float> placed(const Picture& picture, const Frame& frame, int width, int height);

// The number of pixels that shows everything a picture can show on such a frame.
struct Size {
    int width, height;
};
Size finest(const Picture& picture, const Frame& frame);

}  // namespace cydonia::pareidolia
