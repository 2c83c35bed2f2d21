#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"
#include "field/part.h"

namespace cydonia::bench {

// What an independent look at two pieces of land compares. Heights and spacing in metres.

double relief(const Field<float>& land);         // highest less lowest
double pits_per_1000(const Field<float>& land);  // cells lower than all eight neighbours

// How much further parts of a land are from parts of a model than those are from each
// other, all of one size and at hashed places: 1 is as if the land were one more part.
// The distance is that between their distributions (Wasserstein's first), of slopes in
// degrees or of heights over the part's mean.
struct Likeness {
    double slopes = 0.0, heights = 0.0;
};
Likeness likeness(const Field<float>& land, const Field<float>& model, double spacing,
                  std::uint64_t seed);

}  // namespace cydonia::bench
