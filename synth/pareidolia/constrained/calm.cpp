#include "synth/pareidolia/constrained/calm.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "field/parallel.h"
#include "synth/pareidolia/constrained/membrane.h"
#include "synth/pareidolia/constrained/window.h"

namespace cydonia::pareidolia {
namespace {

// Of gradients in shadow, at hidden = 1: the more relief there, the more of it stays dark
// under other suns.
constexpr double kShadowShare = 0.15;
// Slopes are limited, softly, at so many times the light's own.
constexpr double kSteepest = 1.5;
// Of the longer side, over which shadow and window come in.
constexpr double kShadowFeather = 0.015, kWindowFeather = 0.03;

double eased(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// Metres a metre, as of the ground a few cells around.
Field<float> slopes(const Field<float>& heights, double spacing) {
    const int w = heights.width(), h = heights.height();
    Field<float> result(w, h);
    parallel_for(h, 16, [&](int y) {
        for (int x = 0; x < w; ++x) {
            const auto rise = [&](int dx, int dy) {
                return heights(std::clamp(x + dx, 0, w - 1),
                               std::clamp(y + dy, 0, h - 1)) -
                       heights(std::clamp(x - dx, 0, w - 1),
                               std::clamp(y - dy, 0, h - 1));
            };
            result(x, y) =
                static_cast<float>(std::hypot(rise(1, 0), rise(0, 1)) / (2.0 * spacing));
        }
    });
    cv::Mat m(h, w, CV_32F, result.data());
    cv::GaussianBlur(m, m, cv::Size(), 4.0, 0.0, cv::BORDER_REFLECT);
    return result;
}

Field<float> integrated(const Field<float>& base, const Field<float>& share) {
    constexpr double kKeep = 1e-4;  // holds the great shape of the land
    Field<float> force(base.width(), base.height());
    parallel_for(base.height(), 16, [&](int y) {
        for (int x = 0; x < base.width(); ++x) {
            double sum = kKeep * base(x, y);
            const auto edge = [&](int ox, int oy) {
                if (base.contains(ox, oy))
                    sum +=
                        0.5 * (share(x, y) + share(ox, oy)) * (base(x, y) - base(ox, oy));
            };
            edge(x + 1, y);
            edge(x - 1, y);
            edge(x, y + 1);
            edge(x, y - 1);
            force(x, y) = static_cast<float>(sum);
        }
    });
    Membrane(base.width(), base.height(), {.keep = kKeep}, 0.0).solve(force);
    return force;
}

}  // namespace

Field<float> calmed(const Terrain& base, const std::vector<ShadowImage>& images,
                    double hidden, double* smoothed) {
    const Field<float>& heights = base.heights;
    const double side = std::max(heights.width(), heights.height());
    const double shadow_share = std::pow(kShadowShare, hidden);
    const Field<float> slope = slopes(heights, base.spacing);
    Field<float> share(heights.width(), heights.height(), 1.0f);
    double before = 0.0, after = 0.0;
    for (const ShadowImage& image : images) {
        const double steepest = kSteepest * std::tan(image.sun.elevation);
        const Field<float> in_shadow = cells_inside(image.target, true);
        const Field<float> in_window = cells_inside(image.window, true);
        for (std::size_t i = 0; i < share.size(); ++i) {
            const double limited = 1.0 / std::hypot(1.0, slope[i] / steepest);
            const double window = eased(in_window[i] / (kWindowFeather * side));
            const double shadow = eased(in_shadow[i] / (kShadowFeather * side));
            const double of_window = 1.0 + window * (limited - 1.0);
            const double of_shadow = 1.0 + shadow * (shadow_share - 1.0);
            share[i] =
                std::min(share[i], static_cast<float>(std::min(of_window, of_shadow)));
            before += window * slope[i];
            after += window * slope[i] * of_window;
        }
    }
    *smoothed = before > 0.0 ? 1.0 - after / before : 0.0;
    return integrated(heights, share);
}

}  // namespace cydonia::pareidolia
