#include "render/shadow/score.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "field/cells_inside.h"
#include "field/error.h"

namespace cydonia::render {

namespace {

using Mask = Field<std::uint8_t>;

double ratio(std::size_t part, std::size_t whole) {
    return whole == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(whole);
}

void check_window(const Mask& window, const Mask& target) {
    if (!window.empty() && !window.same_shape(target))
        throw bad_request("a window of {}x{} cells does not fit a target of {}x{}",
                          window.width(), window.height(), target.width(),
                          target.height());
}

bool counts(const Mask& window, int x, int y) {
    return window.empty() || window(x, y) != 0;
}

// A view of the mask for OpenCV, without a copy.
cv::Mat matrix(const Mask& mask) {
    return {mask.height(), mask.width(), CV_8U, const_cast<std::uint8_t*>(mask.data())};
}

// Samples in shadow with a lit neighbour, both within the window.
Mask outline(const Mask& mask, const Mask& window, int rays) {
    Mask result(mask.width(), mask.height());
    const auto lit = [&](int x, int y) {
        return mask.contains(x, y) && !mask(x, y) && counts(window, x / rays, y / rays);
    };
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            result(x, y) =
                mask(x, y) && counts(window, x / rays, y / rays) &&
                (lit(x - 1, y) || lit(x + 1, y) || lit(x, y - 1) || lit(x, y + 1));
    return result;
}

// The share of `line` within `distance` samples of `other`.
double share_near(const Mask& line, const Mask& other, double distance) {
    if (std::ranges::none_of(line, [](auto m) { return m != 0; })) return 1.0;
    if (std::ranges::none_of(other, [](auto m) { return m != 0; })) return 0.0;
    const Field<float> away = cells_inside(other, false);
    std::size_t near = 0, all = 0;
    for (int y = 0; y < line.height(); ++y)
        for (int x = 0; x < line.width(); ++x)
            if (line(x, y)) {
                ++all;
                near += away(x, y) <= distance + 1e-3;
            }
    return ratio(near, all);
}

// A disc on cells x cells: those whose middle lies within it.
cv::Mat disc(int cells) {
    cv::Mat element(cells, cells, CV_8U);
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
            element.at<std::uint8_t>(y, x) =
                std::hypot(2 * x + 1 - cells, 2 * y + 1 - cells) <= cells;
    return element;
}

// What a morphological opening by the disc removes. Values at the frame's edge are
// extended beyond it, so that a part that the frame cuts does not become thinner.
Mask thin_parts(const Mask& target, int cells) {
    const cv::Mat element = disc(cells);
    cv::Mat padded, eroded, opened, mirrored;
    cv::copyMakeBorder(matrix(target), padded, cells, cells, cells, cells,
                       cv::BORDER_REPLICATE);
    cv::flip(element, mirrored, -1);  // with the anchor, so that this is a true opening
    const int at = (cells - 1) / 2, back = cells - 1 - at;
    cv::erode(padded, eroded, element, {at, at});
    cv::dilate(eroded, opened, mirrored, {back, back});
    Mask thin(target.width(), target.height());
    for (int y = 0; y < thin.height(); ++y)
        for (int x = 0; x < thin.width(); ++x)
            thin(x, y) = target(x, y) && !opened.at<std::uint8_t>(y + cells, x + cells);
    return thin;
}

}  // namespace

int rays_of(const Mask& cast, const Mask& target) {
    const int rays = target.empty() ? 0 : cast.width() / target.width();
    if (rays < 1 || cast.width() != rays * target.width() ||
        cast.height() != rays * target.height())
        throw bad_request("a cast of {}x{} samples does not fit a target of {}x{} cells",
                          cast.width(), cast.height(), target.width(), target.height());
    return rays;
}

Mask repeated(const Mask& cells, int rays) {
    Mask result(cells.width() * rays, cells.height() * rays);
    for (int y = 0; y < result.height(); ++y)
        for (int x = 0; x < result.width(); ++x) result(x, y) = cells(x / rays, y / rays);
    return result;
}

ShadowScore score(const Mask& cast, const Mask& target, const Mask& window) {
    const int rays = rays_of(cast, target);
    check_window(window, target);
    std::size_t hit = 0, in_cast = 0, in_target = 0;
    for (int y = 0; y < cast.height(); ++y)
        for (int x = 0; x < cast.width(); ++x) {
            if (!counts(window, x / rays, y / rays)) continue;
            const bool c = cast(x, y) != 0, t = target(x / rays, y / rays) != 0;
            hit += c && t;
            in_cast += c;
            in_target += t;
        }
    return {ratio(hit, in_cast + in_target - hit), ratio(hit, in_cast),
            ratio(hit, in_target)};
}

double outline_score(const Mask& cast, const Mask& target, const Mask& window,
                     double tolerance) {
    const int rays = rays_of(cast, target);
    check_window(window, target);
    const Mask drawn = outline(cast, window, rays);
    const Mask wanted = outline(repeated(target, rays), window, rays);
    const double precision = share_near(drawn, wanted, tolerance * rays);
    const double recall = share_near(wanted, drawn, tolerance * rays);
    const double sum = precision + recall;
    return sum > 0.0 ? 2.0 * precision * recall / sum : 0.0;
}

std::optional<double> thin_recall(const Mask& cast, const Mask& target,
                                  const Mask& window, int cells) {
    const int rays = rays_of(cast, target);
    check_window(window, target);
    const Mask thin = thin_parts(target, cells);
    std::size_t hit = 0, all = 0;
    for (int y = 0; y < cast.height(); ++y)
        for (int x = 0; x < cast.width(); ++x)
            if (thin(x / rays, y / rays) && counts(window, x / rays, y / rays)) {
                ++all;
                hit += cast(x, y) != 0;
            }
    if (all == 0) return std::nullopt;
    return ratio(hit, all);
}

double correlation(const Mask& a, const Mask& b, const Mask& window) {
    if (!a.same_shape(b))
        throw bad_request("masks of {}x{} and {}x{} cells have no correlation", a.width(),
                          a.height(), b.width(), b.height());
    check_window(window, a);
    double n = 0.0, in_a = 0.0, in_b = 0.0, both = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!window.empty() && !window[i]) continue;
        n += 1.0;
        in_a += a[i] != 0;
        in_b += b[i] != 0;
        both += a[i] && b[i];
    }
    const double spread = in_a * (n - in_a) * in_b * (n - in_b);
    return spread > 0.0 ? (n * both - in_a * in_b) / std::sqrt(spread) : 0.0;
}

}  // namespace cydonia::render
