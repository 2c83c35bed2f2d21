#pragma once

#include "field/field.h"
#include "field/image.h"
#include "synth/texture/database/database.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// What land of a level is put together from (figure 3). Two neighbouring cells are of one
// patch where the exemplar goes on from one to the other as the land does.
struct PatchFigures {
    double coherent = 0.0;     // share of cells of one patch with all their neighbours
    int patches = 0;           // how many
    std::int64_t typical = 0;  // cells: half the land is in patches of at least this size
    std::int64_t largest = 0;  // cells
    double used =
        0.0;  // share of the exemplars' whole 16x16 blocks that any cell is from
};
PatchFigures patch_figures(const Database& database, const Field<Place>& places,
                           int level = 0);

// Red grows east and green south in the exemplar, blue with its number.
Field<Rgb8> source_map(const Database& database, const Field<Place>& places,
                       int level = 0);

}  // namespace cydonia::texture
