#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "synth/pareidolia/options.h"
#include "synth/pareidolia/picture.h"

namespace cydonia::pareidolia {

// The shadow image I (Rusnell 2009, section 5.2) on the terrain's cells: 1 where at least
// half of a cell is in shadow, and lit beyond the picture. Notes and warnings say how
// large it is, how much of it vanishes because it is thinner than a cell, and how much
// lies beyond the land. Throws bad_request when nothing is in shadow, or everything.
Field<std::uint8_t> shadow_target(const ImageOptions& image, int width, int height,
                                  Progress& progress);

// The same for a picture that was read before; and without messages, where an image
// without any shadow is no error.
Field<std::uint8_t> shadow_target(const ImageOptions& image, const Picture& picture,
                                  int width, int height, Progress& progress);
Field<std::uint8_t> silent_target(const ImageOptions& image, const Picture& picture,
                                  int width, int height);

// The file's name without its extension, or the text, as a safe name of a folder.
std::string image_name(const ImageOptions& image);
// The names of several images, all different: the second "text" becomes "text-2".
std::vector<std::string> image_names(const std::vector<ImageOptions>& images);

}  // namespace cydonia::pareidolia
