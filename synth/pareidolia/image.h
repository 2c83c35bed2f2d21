#pragma once

#include <vector>

#include "field/progress.h"
#include "field/terrain.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// Every image of a stage on the cells of its terrain, with its name and its sun. A note
// says what "auto" chose. Throws bad_request when there are no images or too many, when
// one shows nothing, when its sun cannot cast a shadow, and when its longest shadow does
// not fit the height budget; that message says how many metres it needs.
std::vector<ShadowImage> shadow_images(const Options& options, const Terrain& terrain,
                                       Progress& progress);

}  // namespace cydonia::pareidolia
