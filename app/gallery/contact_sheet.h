#pragma once

#include <string>
#include <vector>

#include "field/image.h"

namespace cydonia {

struct Tile {
    std::string caption;
    Field<Rgb8> picture;
};

// Every picture, whole and small, over its caption; rows of six.
Field<Rgb8> contact_sheet(const std::vector<Tile>& tiles);

// Scaled down to lie within width x height, its proportions kept; smaller ones stay.
Field<Rgb8> fitted(const Field<Rgb8>& picture, int width, int height);

// The best JPEG that takes at most `most_bytes`; smaller in size too where none does.
std::string jpeg_within(const Field<Rgb8>& picture, std::size_t most_bytes);

}  // namespace cydonia
