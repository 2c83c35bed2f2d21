#pragma once

#include <algorithm>
#include <cmath>

#include "field/bezier.h"

namespace cydonia::geometry {

// Positions and directions on the ground, in metres east and north.
inline Point2 from_to(const Point2& a, const Point2& b) {
    return {b[0] - a[0], b[1] - a[1]};
}
inline double dot(const Point2& a, const Point2& b) { return a[0] * b[0] + a[1] * b[1]; }
// Positive where b points to the left of a.
inline double cross(const Point2& a, const Point2& b) {
    return a[0] * b[1] - a[1] * b[0];
}
inline double length(const Point2& a) { return std::sqrt(dot(a, a)); }
inline double distance(const Point2& a, const Point2& b) { return length(from_to(a, b)); }
inline Point2 between(const Point2& a, const Point2& b, double share) {
    return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
}
// The direction with length 1; a direction of length zero stays as it is.
inline Point2 unit_of(const Point2& a) {
    const double l = length(a);
    return l > 0.0 ? Point2{a[0] / l, a[1] / l} : a;
}

struct Box {
    double west = 0.0, east = 0.0, south = 0.0, north = 0.0;

    static Box of(const Point2& a, const Point2& b) {
        return {std::min(a[0], b[0]), std::max(a[0], b[0]), std::min(a[1], b[1]),
                std::max(a[1], b[1])};
    }
    Box grown(double by) const { return {west - by, east + by, south - by, north + by}; }
    Box with(const Box& o) const {
        return {std::min(west, o.west), std::max(east, o.east), std::min(south, o.south),
                std::max(north, o.north)};
    }
    Box within(const Box& o) const {
        return {std::max(west, o.west), std::min(east, o.east), std::max(south, o.south),
                std::min(north, o.north)};
    }
    bool touches(const Box& o) const {
        return west <= o.east && o.west <= east && south <= o.north && o.south <= north;
    }
    bool holds(const Point2& p) const {
        return p[0] >= west && p[0] <= east && p[1] >= south && p[1] <= north;
    }
};

}  // namespace cydonia::geometry
