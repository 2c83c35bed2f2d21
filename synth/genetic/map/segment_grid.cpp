#include "synth/genetic/map/segment_grid.h"

namespace cydonia::genetic {

SegmentGrid::SegmentGrid(std::vector<Segment> segments, const std::array<double, 4>& box)
    : segments_(std::move(segments)),
      side_(int(std::clamp(std::sqrt(double(segments_.size())), 1.0, 512.0))),
      from_{box[0], box[1]},
      size_{(box[2] - box[0]) / side_, (box[3] - box[1]) / side_},
      cells_(std::size_t(side_) * std::size_t(side_)) {
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        auto [a, b] = segments_[i];
        if (a[1] > b[1]) std::swap(a, b);
        const auto [south, north] = span(a[1], b[1], 1);
        for (int row = south; row <= north; ++row) {
            // The part of the segment in this row of cells.
            const double low = std::max(a[1], from_[1] + row * size_[1]),
                         high = std::min(b[1], from_[1] + (row + 1) * size_[1]);
            const auto east_at = [&](double y) {
                return a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
            };
            const bool level = !(b[1] > a[1]);
            const double x0 = level ? a[0] : east_at(low),
                         x1 = level ? b[0] : east_at(high);
            const auto [west, east] = span(std::min(x0, x1), std::max(x0, x1), 0);
            for (int column = west; column <= east; ++column)
                cells_[std::size_t(row * side_ + column)].push_back(std::uint32_t(i));
        }
    }
}

}  // namespace cydonia::genetic
