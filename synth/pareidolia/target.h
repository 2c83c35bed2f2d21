#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "synth/pareidolia/options.h"
#include "synth/pareidolia/picture.h"

namespace cydonia::pareidolia {

// The shadow image I (thesis, section 5.2) on the terrain's cells: 1 in shadow where at
// least half of a cell is; lit beyond the picture. Notes and warnings say what becomes of
// it: how large it is, what is thinner than a cell and vanishes, what lies beyond the
// land. Throws bad_request when nothing is in shadow, or everything.
Field<std::uint8_t> shadow_target(const ImageOptions& image, int width, int height,
                                  Progress& progress);

// The same of a picture that was read before; and without a word, empty of shadow where
// there is none.
Field<std::uint8_t> shadow_target(const ImageOptions& image, const Picture& picture,
                                  int width, int height, Progress& progress);
Field<std::uint8_t> silent_target(const ImageOptions& image, const Picture& picture,
                                  int width, int height);

// The file's name without its ending, or the text, safe as a folder's name.
std::string image_name(const ImageOptions& image);
// Of several images: the second "text" is "text-2", and no two are alike.
std::vector<std::string> image_names(const std::vector<ImageOptions>& images);

}  // namespace cydonia::pareidolia
