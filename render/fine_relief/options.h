#pragma once

#include <optional>

namespace cydonia::render {

// Form finer than a terrain's samples, added to the land that is drawn and checked
// (fine_relief.h). A strength of 0 adds none, 1 as much as real land has.
struct FineReliefOptions {
    // Fine samples for each sample, each way: 1 (none), 2, 4 or 8. The default depends on
    // the quality; it is 1 for land that shows a shadow image.
    std::optional<int> factor;
    double gullies = 1.0;   // down steep slopes
    double crags = 1.0;     // broken ground everywhere, more where it is steep
    double terraces = 0.0;  // walls and benches of hard and soft beds
    double step = 45.0;     // metres, of their thicker beds
    double craters = 0.0;
};

}  // namespace cydonia::render
