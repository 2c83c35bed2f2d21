#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "synth/genetic/map/boundary.h"

namespace cydonia::genetic {

// A grid of cells, each of which lists the straight segments that pass through it, so
// that segments near a position are found without visiting all of them.
class SegmentGrid {
  public:
    using Segment = std::pair<Point2, Point2>;
    // `box` is its west, south, east and north side. Parts of segments outside it are not
    // found.
    SegmentGrid(std::vector<Segment> segments, const std::array<double, 4>& box);

    const Segment& operator[](std::size_t i) const { return segments_[i]; }
    // Calls visit(index) for every segment that may pass through a box, possibly more
    // than once, until it returns false.
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
    // The first and the last cell along an axis; without any, the last is before the
    // first.
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
