#pragma once

#include "field/field.h"
#include "synth/pareidolia/options.h"
#include "synth/pareidolia/picture.h"

namespace cydonia::pareidolia {

// The picture's rectangle on a grid of width x height cells, in cells from the grid's
// north-west corner; y grows south.
struct Frame {
    double x = 0.0, y = 0.0;           // of its middle
    double width = 0.0, height = 0.0;  // before it is turned
    double rotation = 0.0;             // radians, clockwise seen from above
};
Frame frame_of(const Picture& picture, const Placing& placing, int width, int height);

// How light every cell is: the mean over its square, 1 beyond the picture. A picture that
// lies on the whole grid is resized to it and no more.
Field<float> placed(const Picture& picture, const Frame& frame, int width, int height);

// The pixels in which all that a picture has to show on such a frame is seen.
struct Size {
    int width, height;
};
Size finest(const Picture& picture, const Frame& frame);

}  // namespace cydonia::pareidolia
