#include "render/shadow/land_figures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "field/error.h"

namespace cydonia::render {

namespace {

// Both triangles of every square, split from north-west to south-east as the caster's.
double slope_99(const Field<float>& heights, double spacing) {
    std::vector<float> slopes;
    slopes.reserve(2 * heights.size());
    for (int y = 0; y + 1 < heights.height(); ++y)
        for (int x = 0; x + 1 < heights.width(); ++x) {
            const float nw = heights(x, y), ne = heights(x + 1, y);
            const float sw = heights(x, y + 1), se = heights(x + 1, y + 1);
            slopes.push_back(std::hypot(ne - nw, se - ne));
            slopes.push_back(std::hypot(se - sw, sw - nw));
        }
    const auto at = slopes.begin() + static_cast<std::ptrdiff_t>(
                                         0.99 * static_cast<double>(slopes.size()));
    std::nth_element(slopes.begin(), at, slopes.end());
    return *at / spacing;
}

double laplacian_kurtosis(const Field<float>& heights) {
    std::vector<double> values;
    values.reserve(heights.size());
    for (int y = 2; y + 2 < heights.height(); ++y)
        for (int x = 2; x + 2 < heights.width(); ++x)
            values.push_back(static_cast<double>(heights(x - 1, y)) + heights(x + 1, y) +
                             heights(x, y - 1) + heights(x, y + 1) - 4.0 * heights(x, y));
    const double n = static_cast<double>(values.size());
    double mean = 0.0, second = 0.0, fourth = 0.0;
    for (const double v : values) mean += v / n;
    for (const double v : values) {
        const double square = (v - mean) * (v - mean);
        second += square / n;
        fourth += square * square / n;
    }
    return second > 0.0 ? fourth / (second * second) - 3.0 : 0.0;
}

}  // namespace

LandFigures land_figures(const Field<float>& heights, double spacing) {
    if (std::min(heights.width(), heights.height()) < 5)
        throw bad_request("the land's figures need at least 5x5 samples, not {}x{}",
                          heights.width(), heights.height());
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    return {static_cast<double>(*high) - *low, slope_99(heights, spacing),
            laplacian_kurtosis(heights)};
}

}  // namespace cydonia::render
