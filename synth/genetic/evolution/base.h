#pragma once

#include "field/field.h"
#include "synth/genetic/evolution/fitness.h"
#include "synth/genetic/evolution/samples.h"

namespace cydonia::genetic {

// The coarsest level of detail (section IV.3.3.3), without the cliffs that pasted chunks
// leave between regions of different height (a wish of section VII.7).
struct Base {
    // The large-scale height of each cell: the mean of its type's samples, with slopes
    // between neighbours that are no steeper than their land.
    Field<float> pattern;
    // The share, 0 to 1, of its chunk's own relief that a cell has. It is least beside
    // land of another type.
    Field<float> own;
    // The samples, whose detail is all of their land less the mean of their type.
    LevelSamples samples;
};

Base base_of(const LevelSamples& samples, const Regions& regions);

}  // namespace cydonia::genetic
