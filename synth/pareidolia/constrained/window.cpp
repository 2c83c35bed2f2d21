#include "synth/pareidolia/constrained/window.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace cydonia::pareidolia {
namespace {

// Of the terrain's longer side: how far the window reaches beyond the image, and the gaps
// that belong to it.
constexpr double kReach = 0.08, kGap = 0.16;

}  // namespace

Field<float> cells_inside(const Field<std::uint8_t>& mask, bool value) {
    cv::Mat inside(mask.height(), mask.width(), CV_8U);
    std::transform(mask.begin(), mask.end(), inside.begin<std::uint8_t>(),
                   [&](std::uint8_t m) { return (m != 0) == value ? 1 : 0; });
    cv::Mat distance;
    cv::distanceTransform(inside, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    Field<float> result(mask.width(), mask.height());
    std::copy(distance.begin<float>(), distance.end<float>(), result.begin());
    return result;
}

Field<std::uint8_t> window_of(const Field<std::uint8_t>& target,
                              const Field<float>& noise) {
    const double side = std::max(target.width(), target.height());
    const double reach = kReach * side, gap = kGap * side;
    const Field<float> away = cells_inside(target, false);
    Field<std::uint8_t> near(target.width(), target.height());
    for (std::size_t i = 0; i < near.size(); ++i) near[i] = away[i] < gap;
    const Field<float> inside = cells_inside(near, true);
    Field<std::uint8_t> window(target.width(), target.height());
    for (std::size_t i = 0; i < window.size(); ++i) {
        const double within = inside[i] - (gap - reach);
        window[i] = target[i] || within > reach * (noise[i] - 0.5);
    }
    return window;
}

}  // namespace cydonia::pareidolia
