#pragma once

#include "field/field.h"
#include "field/image.h"
#include "synth/texture/database/database.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// Figures of the patches that the land of a level is composed of (figure 3). Two
// neighbouring cells belong to one patch where they are neighbours in the exemplar, too.
struct PatchFigures {
    double coherent = 0.0;     // share of cells in one patch with all their neighbours
    int patches = 0;           // their number
    std::int64_t typical = 0;  // cells of the largest patch; half of the land is in
                               // patches at least as large
    std::int64_t largest = 0;  // cells
    double used = 0.0;  // share of the exemplars' 16x16 blocks from which any cell comes
};
PatchFigures patch_figures(const Database& database, const Field<Origin>& origins,
                           int level = 0);

// A picture of the cells' origins: red grows to the east and green to the south in the
// exemplar, blue with its number.
Field<Rgb8> source_map(const Database& database, const Field<Origin>& origins,
                       int level = 0);

}  // namespace cydonia::texture
