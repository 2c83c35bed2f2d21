#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "synth/genetic/map/boundary.h"

namespace cydonia::genetic {

// Straight segments by where they pass, so that those near a place are found without
// looking at all.
class SegmentGrid {
  public:
    using Segment = std::pair<Point2, Point2>;
    // What is outside of the box, west, south, east and north, is found nowhere.
    SegmentGrid(std::vector<Segment> segments, const std::array<double, 4>& box);

    const Segment& operator[](std::size_t i) const { return segments_[i]; }
    // visit(index) for all that may be in a box, some of them several times, as long as
    // it returns true.
    template <class Visit>
    void near(const std::array<double, 4>& box, const Visit& visit) const {
        const auto [west, east] = span(box[0], box[2], 0);
        const auto [south, north] = span(box[1], box[3], 1);
        for (int row = south; row <= north; ++row)
            for (int column = west; column <= east; ++column)
                for (const std::uint32_t i : cells_[std::size_t(row * side_ + column)])
                    if (!visit(std::size_t(i))) return;
    }

  private:
    // The first and the last cell along an axis; none: the last before the first.
    std::pair<int, int> span(double low, double high, std::size_t axis) const {
        const auto cell = [&](double v) {
            return std::floor((v - from_[axis]) / size_[axis]);
        };
        return {int(std::clamp(cell(low), 0.0, double(side_))),
                int(std::clamp(cell(high), -1.0, side_ - 1.0))};
    }

    std::vector<Segment> segments_;
    int side_;  // cells along each axis
    Point2 from_, size_;
    std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace cydonia::genetic
