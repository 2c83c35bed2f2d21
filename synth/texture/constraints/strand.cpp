#include "synth/texture/constraints/strand.h"

#include "synth/geometry/nearest.h"

namespace cydonia::texture {
namespace {

// The share of the right side's properties beside the place `share` along a line, for
// something that lies `v` from it: 0 or 1, and around a free end all between.
double right_share(const Shape& shape, int segment, double share, const Point2& v) {
    const bool begins = share <= 0.0, ends = share >= 1.0;
    const Point2& tangent = shape.tangents[segment + (ends ? 1 : 0)];
    const bool first = begins && segment == 0;
    const bool last = ends && segment + 1 == shape.segments();
    if (!shape.closed && (first || last)) {
        const double far = length(v);
        const double left = far > 0.0 ? cross(tangent, v) / far : 0.0;  // cosine
        // Level at both sides, as the Hermite cubic in the angle, which is within 1% of
        // it.
        return 0.5 * (1.0 - std::clamp(left, -1.0, 1.0));
    }
    // At a corner the mean direction tells the sides apart.
    const Point2 way = begins || ends
                           ? tangent
                           : from_to(shape.points[segment], shape.points[segment + 1]);
    return cross(way, v) >= 0.0 ? 0.0 : 1.0;
}

}  // namespace

Asked asked_by(const Shape& shape, const Course& course, int segment, const Point2& p) {
    const Point2 &a = shape.points[segment], &b = shape.points[segment + 1];
    const double share = nearest_share(a, b, p);
    const Point2 v = from_to(between(a, b, share), p);
    const double d = length(v);
    const double right = right_share(shape, segment, share, v);
    const double along =
        shape.along[segment] + share * (shape.along[segment + 1] - shape.along[segment]);
    const Trait trait = course.at(along);
    const auto mixed = [right](const std::array<double, 2>& sides) {
        return sides[0] + right * (sides[1] - sides[0]);
    };
    return {trait.height + mixed(trait.gradient) * d, d, mixed(trait.area)};
}

}  // namespace cydonia::texture
