#include "field/quantise.h"

#include <algorithm>
#include <cmath>

namespace cydonia {

Heights16 quantised(const Field<float>& heights) {
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    Heights16 result{Field<std::uint16_t>(heights.width(), heights.height()), *low, 0.0};
    result.range = std::max(static_cast<double>(*high) - *low, 1e-3);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const double level = (heights[i] - result.base) / result.range * 65535.0;
        result.levels[i] = static_cast<std::uint16_t>(std::lround(level));
    }
    return result;
}

Field<float> heights_of(const Heights16& h) {
    Field<float> result(h.levels.width(), h.levels.height());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = static_cast<float>(h.base + h.range * (h.levels[i] / 65535.0));
    return result;
}

}  // namespace cydonia
