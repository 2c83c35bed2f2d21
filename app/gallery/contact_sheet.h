#pragma once

#include <string>
#include <vector>

#include "field/image.h"

namespace cydonia {

struct Tile {
    std::string caption;
    Field<Rgb8> picture;
};

// All pictures, scaled down, each above its caption, in rows of six.
Field<Rgb8> contact_sheet(const std::vector<Tile>& tiles);

// Scaled down to fit width x height with its proportions kept. Smaller pictures stay.
Field<Rgb8> fitted(const Field<Rgb8>& picture, int width, int height);

// The best JPEG of at most `most_bytes`; if none is small enough, of fewer pixels.
std::string jpeg_within(const Field<Rgb8>& picture, std::size_t most_bytes);

}  // namespace cydonia
