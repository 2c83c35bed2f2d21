#pragma once

#include "field/field.h"
#include "synth/genetic/evolution/fitness.h"
#include "synth/genetic/evolution/samples.h"

namespace cydonia::genetic {

// The coarsest level of detail (section IV.3.3.3), without the cliffs that pasted chunks
// leave between regions of different height (its VII.7).
struct Base {
    // How high the land of each cell is to lie on the whole: as its type's samples do,
    // and where neighbours' differ a slope between them that is no steeper than theirs.
    Field<float> pattern;
    // How much of its chunk's own relief a cell has, 0 to 1: least where it meets another
    // type's land.
    Field<float> own;
    // The samples with all of their land, less their type's mean, as detail.
    LevelSamples samples;
};

Base base_of(const LevelSamples& samples, const Regions& regions);

}  // namespace cydonia::genetic
