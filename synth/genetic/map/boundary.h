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
    double envelope = 0.0;    // how far it may stray
    // How far to its left and right, as an angle at its ends, there is nothing else: it
    // keeps to less than half of that.
    std::array<double, 2> free_at{};
    // Its course at its ends, to the left of straight on: where two boundaries meet they
    // can meet without a corner.
    std::array<double, 2> course{};
    double segment = 1.0;  // what it is made of are no longer than that
    // West, south, east and north of what shows: parts beyond stay straight.
    std::array<double, 4> window{-kFar, -kFar, kFar, kFar};
    static constexpr double kFar = std::numeric_limits<double>::infinity();
};

// Boundary refinement by the thesis' genetic algorithm (section IV.3.1): genes are the
// turns from segment to segment, fit are those whose sharpness S asks for (eq. IV.3). A
// long boundary is refined from coarse to fine, a few segments at a time, each of them
// refined in turn. Besides the thesis' limit of the absolute angle it keeps to its
// envelope and clear of its neighbours, and does not cross itself (its VI.1.3). Ends are
// exact.
std::vector<Point2> refined(const StraightBoundary& boundary, std::uint64_t seed);

// Where two segments that do not follow each other meet.
std::optional<Point2> crossing_of(const std::vector<Point2>& line);
inline bool crosses_itself(const std::vector<Point2>& line) {
    return crossing_of(line).has_value();
}

}  // namespace cydonia::genetic
