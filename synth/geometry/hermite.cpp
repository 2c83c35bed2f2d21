#include "synth/geometry/hermite.h"

#include <algorithm>

namespace cydonia::geometry {
namespace {

double secant(const Knot& a, const Knot& b) {
    return (b.value - a.value) / (b.at - a.at);
}

// The weighted harmonic mean of the slopes on both sides of a knot; 0 at a top or a
// bottom.
double tangent(const Knot& a, const Knot& b, const Knot& c) {
    const double before = secant(a, b), after = secant(b, c);
    if (before * after <= 0.0) return 0.0;
    const double p = (b.at - a.at) + 2.0 * (c.at - b.at);
    const double q = 2.0 * (b.at - a.at) + (c.at - b.at);
    return (p + q) / (p / before + q / after);
}

// The knots of a ring, repeated for two turns before and after.
std::vector<Knot> wrapped(const std::vector<Knot>& knots, double length) {
    std::vector<Knot> all;
    for (int turn = -2; turn <= 2; ++turn)
        for (const Knot& knot : knots)
            all.push_back({knot.at + turn * length, knot.value});
    return all;
}

}  // namespace

Hermite::Hermite(std::vector<Knot> knots, double length, bool ring)
    : knots_(ring && knots.size() > 1 ? wrapped(knots, length) : std::move(knots)) {
    const std::size_t n = knots_.size();
    tangents_.assign(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i)
        tangents_[i] = tangent(knots_[i - 1], knots_[i], knots_[i + 1]);
    if (ring || n < 2) return;
    if (knots_[0].at <= 0.0) tangents_[0] = secant(knots_[0], knots_[1]);
    if (knots_[n - 1].at >= length)
        tangents_[n - 1] = secant(knots_[n - 2], knots_[n - 1]);
}

double Hermite::operator()(double at) const {
    const auto after =
        std::upper_bound(knots_.begin(), knots_.end(), at,
                         [](double place, const Knot& knot) { return place < knot.at; });
    if (after == knots_.begin()) return knots_.front().value;
    if (after == knots_.end()) return knots_.back().value;
    const Knot &a = *(after - 1), &b = *after;
    const auto i = static_cast<std::size_t>(after - knots_.begin());
    const double width = b.at - a.at, t = (at - a.at) / width, s = 1.0 - t;
    return a.value * s * s * (1.0 + 2.0 * t) + b.value * t * t * (3.0 - 2.0 * t) +
           width * t * s * (tangents_[i - 1] * s - tangents_[i] * t);
}

}  // namespace cydonia::geometry
