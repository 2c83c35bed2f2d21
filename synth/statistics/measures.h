#pragma once

#include <utility>
#include <vector>

#include "field/terrain.h"
#include "synth/statistics/analysis.h"
#include "synth/statistics/features.h"

namespace cydonia::genetic {

// What of a land is told by numbers, sample by sample and feature by feature: what the
// "studying" of a terrain sample leaves (Saunders 2006, section V.3.3.3).
struct Measures {
    // A number a sample, NaN where there is none. A quantity may have several.
    std::vector<std::pair<Quantity, Field<float>>> fields;
    struct Kind {
        std::vector<std::pair<Quantity, float Feature::*>> numbers;
        std::vector<Feature> features;
    };
    std::vector<Kind> kinds;
};
Measures measures_of(const Terrain& terrain);

}  // namespace cydonia::genetic
