#pragma once

#include <algorithm>

namespace cydonia {

// Rises from 0 at `none` to 1 at `full` and is level at both ends; it falls where full <
// none.
constexpr double smoothstep(double none, double full, double x) {
    const double t = std::clamp((x - none) / (full - none), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}
constexpr float smoothstep(float none, float full, float x) {
    const float t = std::clamp((x - none) / (full - none), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

}  // namespace cydonia
