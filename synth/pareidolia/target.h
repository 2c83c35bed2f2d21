#pragma once

#include <cstdint>
#include <string>

#include "field/field.h"
#include "field/progress.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// The shadow image I (thesis, section 5.2) on the terrain's cells: 1 in shadow where at
// least half of a cell is dark. A target of another size is stretched, and a note says
// so. Throws bad_request when it is all dark or has no shadow.
Field<std::uint8_t> shadow_target(const ImageOptions& image, int width, int height,
                                  Progress& progress);

// The file's name without its ending, safe as a folder's name.
std::string image_name(const ImageOptions& image);

}  // namespace cydonia::pareidolia
