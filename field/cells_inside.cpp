#include "field/cells_inside.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace cydonia {

Field<float> cells_inside(const Field<std::uint8_t>& mask, bool value) {
    Field<std::uint8_t> inside(mask.width(), mask.height());
    std::ranges::transform(mask, inside.begin(), [&](std::uint8_t m) {
        return static_cast<std::uint8_t>((m != 0) == value);
    });
    Field<float> result(mask.width(), mask.height());
    const cv::Mat from(mask.height(), mask.width(), CV_8U, inside.data());
    cv::Mat to(mask.height(), mask.width(), CV_32F, result.data());
    cv::distanceTransform(from, to, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return result;
}

}  // namespace cydonia
