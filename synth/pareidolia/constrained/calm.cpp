#include "synth/pareidolia/constrained/calm.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "field/cells_inside.h"
#include "field/parallel.h"
#include "synth/pareidolia/constrained/membrane.h"

namespace cydonia::pareidolia {
namespace {

// The factor of gradients in shadow at hidden = 1: the more relief there is, the more of
// it stays dark under other suns.
constexpr double kShadowShare = 0.3;
// The land falls along the light: in shadow by as much as it must in total, and on lit
// ground, at hidden = 1, by half of that, so that no single slope has the image's shape.
constexpr double kShadowTilt = 1.0, kLitTilt = 0.5;
// Slopes on lit ground are softly limited at so many times the light's own.
constexpr double kSteepest = 1.5;
// The width of the transitions at shadows and windows, as a share of the longer side.
constexpr double kShadowFeather = 0.015, kWindowFeather = 0.03;
// The cost of a change in height alone, so that ground that nothing else holds stays
// where it was.
constexpr double kKeepCalm = 1e-6;

double eased(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// The slope, in metres a metre, averaged over a few cells around.
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

// The land whose gradient is, in the least squares, `share` times that of `base` plus
// `tilt` (x, y; metres a cell). It is the solution of a screened Poisson equation for the
// change, so that ground that must stay does so at any height.
Field<float> integrated(const Field<float>& base, const Field<float>& share,
                        const Field<float>& tilt_x, const Field<float>& tilt_y) {
    Field<float> change(base.width(), base.height());
    parallel_for(base.height(), 16, [&](int y) {
        for (int x = 0; x < base.width(); ++x) {
            double sum = 0.0;
            const auto edge = [&](int dx, int dy) {
                const int ox = x + dx, oy = y + dy;
                if (!base.contains(ox, oy)) return;
                const double more = 0.5 * (share(x, y) + share(ox, oy)) - 1.0;
                sum += more * (base(x, y) - base(ox, oy)) -
                       0.5 * (double(dx) * (tilt_x(x, y) + tilt_x(ox, oy)) +
                              double(dy) * (tilt_y(x, y) + tilt_y(ox, oy)));
            };
            edge(1, 0);
            edge(-1, 0);
            edge(0, 1);
            edge(0, -1);
            change(x, y) = static_cast<float>(sum);
        }
    });
    Membrane(base.width(), base.height(), {.keep = kKeepCalm}, 0.0).solve(change);
    for (std::size_t i = 0; i < base.size(); ++i) change[i] += base[i];
    return change;
}

}  // namespace

Field<float> calmed(const Terrain& base, const std::vector<ShadowImage>& images,
                    double hidden, double* smoothed) {
    const Field<float>& heights = base.heights;
    const double side = std::max(heights.width(), heights.height());
    const double shadow_share = std::pow(kShadowShare, hidden);
    const Field<float> slope = slopes(heights, base.spacing);
    Field<float> share(heights.width(), heights.height(), 1.0f);
    Field<float> tilt_x(share.width(), share.height()), tilt_y = tilt_x;
    double before = 0.0, after = 0.0;
    for (const ShadowImage& image : images) {
        const double steepest = kSteepest * std::tan(image.sun.elevation);
        const double east = std::sin(image.sun.azimuth);
        const double north = std::cos(image.sun.azimuth);
        const Field<float> in_shadow = cells_inside(image.target, true);
        const Field<float> in_window = cells_inside(image.window, true);
        for (std::size_t i = 0; i < share.size(); ++i) {
            const double limited = 1.0 / std::hypot(1.0, slope[i] / steepest);
            const double window = eased(in_window[i] / (kWindowFeather * side));
            const double shadow = eased(in_shadow[i] / (kShadowFeather * side));
            const double of_window = 1.0 + window * (limited - 1.0);
            share[i] = std::min(
                share[i],
                static_cast<float>(of_window + shadow * (shadow_share - of_window)));
            const double lit_tilt = kLitTilt * std::min(1.0, hidden);
            const double tilt = std::tan(image.sun.elevation) * base.spacing * window *
                                (lit_tilt + shadow * (kShadowTilt - lit_tilt));
            // The fall along the light of other suns is taken into account.
            const double missing =
                std::max(0.0, tilt - (tilt_x[i] * east - tilt_y[i] * north));
            tilt_x[i] += static_cast<float>(east * missing);
            tilt_y[i] -= static_cast<float>(north * missing);
            before += window * slope[i];
            after += window * slope[i] * of_window;
        }
    }
    *smoothed = before > 0.0 ? 1.0 - after / before : 0.0;
    return integrated(heights, share, tilt_x, tilt_y);
}

}  // namespace cydonia::pareidolia
