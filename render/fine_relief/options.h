#pragma once

#include <optional>

namespace cydonia::render {

// Form finer than a terrain's samples, on the land that is drawn and checked
// (fine_relief.h). Strengths are shares of what suits real land: 0 none, 1 as found
// there.
struct FineReliefOptions {
    // Fine samples a sample, each way: 1 (none), 2, 4 or 8. Default: by the quality; 1
    // for land that promises a shadow image.
    std::optional<int> factor;
    double gullies = 1.0;   // down steep slopes
    double crags = 1.0;     // broken ground everywhere, more where it is steep
    double terraces = 0.0;  // walls and benches of hard and soft beds
    double step = 45.0;     // metres, of their thicker beds
    double craters = 0.0;
};

}  // namespace cydonia::render
