#include "render/cameras/path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace cydonia::render {
namespace {

// The cubic over a step of `width` with end values a, b and end slopes p, q, at the share
// `t` of the step.
template <class T>
T hermite(const T& a, const T& p, const T& b, const T& q, double width, double t) {
    const double t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * a + (width * (t3 - 2 * t2 + t)) * p +
           (3 * t2 - 2 * t3) * b + (width * (t3 - t2)) * q;
}

// The index at which the step that contains `x` starts. x lies within the values.
std::size_t step_of(const std::vector<double>& values, double x) {
    const auto after = std::upper_bound(values.begin() + 1, values.end() - 1, x);
    return static_cast<std::size_t>(after - values.begin()) - 1;
}

// Slopes that keep the cubics of a rising sequence rising: a weighted harmonic mean of
// the slopes of the steps on both sides, zero where one of them is.
std::vector<double> monotone_slopes(const std::vector<double>& x,
                                    const std::vector<double>& y, bool eased) {
    const auto step = [](const std::vector<double>& v, std::size_t i) {
        return v[i + 1] - v[i];
    };
    std::vector<double> slopes(x.size(), 0.0);
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
        const double before = step(x, i - 1), after = step(x, i);
        const double p = step(y, i - 1) / before, q = step(y, i) / after;
        if (p > 0.0 && q > 0.0)
            slopes[i] = 3.0 * (before + after) /
                        ((2.0 * after + before) / p + (after + 2.0 * before) / q);
    }
    if (!eased && x.size() > 1) {
        slopes.front() = step(y, 0) / step(x, 0);
        slopes.back() = step(y, x.size() - 2) / step(x, x.size() - 2);
    }
    return slopes;
}

// Catmull-Rom tangents for uneven knots; the curve does not bend at its ends.
std::vector<Vec3> tangents_of(const std::vector<double>& knots,
                              const std::vector<Vec3>& points) {
    const std::size_t n = points.size();
    if (n < 2) return std::vector<Vec3>(n);
    const auto chord = [&](std::size_t i) {
        return (1.0 / (knots[i + 1] - knots[i])) * (points[i + 1] - points[i]);
    };
    std::vector<Vec3> tangents(n);
    tangents.front() = chord(0);
    tangents.back() = chord(n - 2);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = knots[i] - knots[i - 1], after = knots[i + 1] - knots[i];
        tangents[i] =
            (1.0 / (before + after)) * (after * chord(i - 1) + before * chord(i));
    }
    if (n > 2) {
        tangents.front() = 0.5 * (3.0 * chord(0) - tangents[1]);
        tangents.back() = 0.5 * (3.0 * chord(n - 2) - tangents[n - 2]);
    }
    return tangents;
}

}  // namespace

TimedCurve::TimedCurve(std::vector<double> times, const std::vector<Vec3>& points,
                       bool eased)
    : times_(std::move(times)) {
    assert(times_.size() == points.size() && !points.empty());
    for (const Vec3& point : points) {
        const double apart = points_.empty() ? 1.0 : length(point - points_.back());
        if (apart > 1e-9) {
            // Centripetal: the distance between knots is the square root of the length.
            knots_.push_back(points_.empty() ? 0.0 : knots_.back() + std::sqrt(apart));
            points_.push_back(point);
        }
        way_.push_back(knots_.back());
    }
    pace_ = monotone_slopes(times_, way_, eased);
    tangents_ = tangents_of(knots_, points_);
}

Vec3 TimedCurve::shape_at(double knot) const {
    if (points_.size() == 1) return points_.front();
    const std::size_t i = step_of(knots_, knot);
    const double width = knots_[i + 1] - knots_[i];
    return hermite(points_[i], tangents_[i], points_[i + 1], tangents_[i + 1], width,
                   std::clamp((knot - knots_[i]) / width, 0.0, 1.0));
}

Vec3 TimedCurve::operator()(double time) const {
    if (time <= times_.front()) return points_.front();
    if (time >= times_.back()) return points_.back();
    const std::size_t i = step_of(times_, time);
    const double width = times_[i + 1] - times_[i];
    return shape_at(hermite(way_[i], pace_[i], way_[i + 1], pace_[i + 1], width,
                            (time - times_[i]) / width));
}

std::vector<double> shutter_times(const CameraOptions& options, double frame) {
    const double open = options.shutter_angle / (2.0 * std::numbers::pi);
    std::vector<double> times;
    for (int i = 0; i < options.shutter_samples; ++i)
        times.push_back(frame + open * ((i + 0.5) / options.shutter_samples - 0.5));
    return times;
}

}  // namespace cydonia::render
