#pragma once

#include <utility>
#include <vector>

#include "field/terrain.h"
#include "synth/statistics/analysis.h"
#include "synth/statistics/features.h"

namespace cydonia::statistics {

// The numbers that describe a land, for each sample and each feature: the result of
// "studying" a terrain sample (Saunders 2006, section V.3.3.3).
struct Measures {
    // Fields with a number for each sample, or NaN where there is none. A quantity may
    // have several fields.
    std::vector<std::pair<Quantity, Field<float>>> fields;
    struct Kind {
        std::vector<std::pair<Quantity, float Feature::*>> numbers;
        std::vector<Feature> features;
    };
    std::vector<Kind> kinds;
};
Measures measures_of(const Terrain& terrain);

}  // namespace cydonia::statistics
