#include "render/colour/exposure.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "render/colour/colour.h"

namespace cydonia::render {
namespace {

constexpr double kBright = 0.5;
constexpr double kShareBelowBright = 0.9;
constexpr double kMostStops = 6.0;

}  // namespace

double own_stops(const Field<Rgb>& acescg) {
    if (acescg.size() == 0) return 0.0;
    std::vector<float> light(acescg.size());
    std::transform(acescg.begin(), acescg.end(), light.begin(), luminance);
    const auto bright =
        light.begin() + static_cast<std::ptrdiff_t>(
                            kShareBelowBright * static_cast<double>(light.size() - 1));
    std::nth_element(light.begin(), bright, light.end());
    if (!(*bright > 0.0f)) return 0.0;
    return std::clamp(std::log2(kBright / *bright), -kMostStops, kMostStops);
}

double steady_stops(std::vector<double> own) {
    assert(!own.empty());
    const auto middle = own.begin() + static_cast<std::ptrdiff_t>(own.size() / 2);
    std::nth_element(own.begin(), middle, own.end());
    return *middle;
}

}  // namespace cydonia::render
