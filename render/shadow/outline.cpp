#include "render/shadow/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "field/error.h"
#include "render/shadow/shading.h"

namespace cydonia::render {

namespace {

constexpr double kNear = 2.0;  // cells

// A sum and how many.
struct Sum {
    double total = 0.0;
    std::size_t count = 0;
    void add(double value) {
        total += value;
        ++count;
    }
    double mean() const { return total / static_cast<double>(count); }
};

}  // namespace

Field<std::uint8_t> near_outline(const Field<std::uint8_t>& target) {
    // To the nearest cell of the other kind, whose middle is half a cell beyond the
    // outline.
    const auto distance = [&](bool from_dark) {
        cv::Mat from(target.height(), target.width(), CV_8U), result;
        std::ranges::transform(target, from.begin<std::uint8_t>(), [&](auto t) {
            return static_cast<std::uint8_t>((t != 0) == from_dark);
        });
        cv::distanceTransform(from, result, cv::DIST_L2, cv::DIST_MASK_PRECISE);
        return result;
    };
    Field<std::uint8_t> near(target.width(), target.height());
    const auto dark = std::ranges::count_if(target, [](auto t) { return t != 0; });
    if (dark == 0 || dark == static_cast<std::ptrdiff_t>(target.size())) return near;
    const cv::Mat away = distance(true) + distance(false);  // one of them is 0
    std::transform(away.begin<float>(), away.end<float>(), near.begin(),
                   [](float d) { return static_cast<std::uint8_t>(d <= kNear + 0.5); });
    return near;
}

double outline_shading(const Field<float>& heights, double spacing, const Sun& sun,
                       const Field<std::uint8_t>& near) {
    if (!near.same_shape(heights) || std::min(near.width(), near.height()) < 3)
        throw bad_request("an outline of {}x{} cells does not fit {}x{} heights",
                          near.width(), near.height(), heights.width(), heights.height());
    const Field<float> light = shading(heights, spacing, sun);
    std::array<Sum, 2> sums;  // elsewhere, near
    for (int y = 1; y + 1 < light.height(); ++y)
        for (int x = 1; x + 1 < light.width(); ++x)
            sums[near(x, y) != 0].add(0.5 *
                                      std::hypot(light(x + 1, y) - light(x - 1, y),
                                                 light(x, y + 1) - light(x, y - 1)));
    const auto [elsewhere, close] = sums;
    if (close.count == 0 || !(elsewhere.total > 0.0)) return 1.0;
    return close.mean() / elsewhere.mean();
}

}  // namespace cydonia::render
