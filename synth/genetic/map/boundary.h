#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace cydonia::genetic {

using Point2 = std::array<double, 2>;

// A straight boundary that is to be refined. Metres and radians.
struct StraightBoundary {
    Point2 from{}, to{};
    double smoothness = 0.5;  // S
    double envelope = 0.0;    // how far it may stray, metres
    // The free angle at its ends on either side, up to the next boundary. It keeps to
    // less than half of that.
    std::array<double, 2> free_at{};
    // Its direction at its ends, to the left of straight ahead, so that two boundaries
    // can meet without a corner.
    std::array<double, 2> course{};
    double segment = 1.0;  // longest segment of the result, metres
    // The west, south, east and north side of the visible part. Outside it boundaries
    // stay straight.
    std::array<double, 4> window{-kFar, -kFar, kFar, kFar};
    static constexpr double kFar = std::numeric_limits<double>::infinity();
};

// Refines a boundary by the thesis' genetic algorithm (section IV.3.1). Genes are the
// turns from segment to segment; fitness rewards the sharpness that S asks for (eq.
// IV.3). A long boundary is refined from coarse to fine, a few segments at a time, each
// of them refined in turn. Besides the thesis' limit of the absolute angle the result
// keeps within its envelope, clear of its neighbours, and does not cross itself (a wish
// of VI.1.3). Its ends are exact.
std::vector<Point2> refined(const StraightBoundary& boundary, std::uint64_t seed);

// Where two segments that do not follow each other cross, if any do.
std::optional<Point2> crossing_of(const std::vector<Point2>& line);
inline bool crosses_itself(const std::vector<Point2>& line) {
    return crossing_of(line).has_value();
}

}  // namespace cydonia::genetic
