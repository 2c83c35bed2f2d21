#include "synth/texture/constraints/curve_constraint.h"

#include "synth/geometry/nearest.h"

namespace cydonia::texture {

using namespace geometry;

namespace {

// The weight of the right side's properties for something that lies at `v` from the point
// at `share` of a line: 0 or 1, and around a free end anything between.
double right_share(const Shape& shape, int segment, double share, const Point2& v) {
    const bool begins = share <= 0.0, ends = share >= 1.0;
    const Point2& tangent = shape.tangents[segment + (ends ? 1 : 0)];
    const bool first = begins && segment == 0;
    const bool last = ends && segment + 1 == shape.segments();
    if (!shape.closed && (first || last)) {
        const double far = length(v);
        const double left = far > 0.0 ? cross(tangent, v) / far : 0.0;  // cosine
        // This is level at both sides and within 1% of the Hermite cubic in the angle.
        return 0.5 * (1.0 - std::clamp(left, -1.0, 1.0));
    }
    // At a corner the mean direction decides which side is which.
    const Point2 way = begins || ends
                           ? tangent
                           : from_to(shape.points[segment], shape.points[segment + 1]);
    return cross(way, v) >= 0.0 ? 0.0 : 1.0;
}

}  // namespace

Demand demand_of(const Shape& shape, const Course& course, int segment, const Point2& p) {
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
