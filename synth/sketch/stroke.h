#pragma once

#include "field/field.h"
#include "field/progress.h"
#include "synth/sketch/options.h"

namespace cydonia::sketch {

// So many heights of a silhouette, from its leftmost point to its rightmost: a row,
// metres. Says where it folds back. Throws bad_request: nothing drawn, or no width.
Field<float> heights_of(const Silhouette& silhouette, int values, const std::string& name,
                        Progress& progress);

}  // namespace cydonia::sketch
