// Rusnell 2009, section 5.3, step 7, Algorithms 5 to 7, with heights instead of costs: a
// lower bound of the cost is an upper bound of the height, and c_min is the tallest
// primary feature.
#include "synth/pareidolia/height_bound.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "field/cells_inside.h"
#include "field/parallel.h"

namespace cydonia::pareidolia {
namespace {

enum Zone : std::uint8_t { kFree, kShadow, kAntiShadow };

// A stretch of one zone along a row of the light frame: samples [first, past).
struct Stretch {
    Zone zone;
    int first, past;
    bool holds(int sample) const { return sample >= first && sample < past; }
};

std::vector<Stretch> stretches_of(std::span<const std::uint8_t> row) {
    std::vector<Stretch> result;
    for (int i = 0; i < static_cast<int>(row.size()); ++i) {
        if (result.empty() || result.back().zone != row[i])
            result.push_back({static_cast<Zone>(row[i]), i, i + 1});
        result.back().past = i + 1;
    }
    return result;
}

// The bound along one row of light.
class RowBound {
  public:
    RowBound(std::span<const std::uint8_t> regions, std::span<const float> base,
             double rise, double highest, std::span<float> bound)
        : base_(base), rise_(rise), highest_(highest), bound_(bound) {
        const auto stretches = stretches_of(regions);
        const int count = static_cast<int>(stretches.size());
        for (const Stretch& s : stretches)
            if (s.zone == kShadow) bound_shadow(s);
        for (int i = 0; i < count; ++i) {
            if (stretches[i].zone != kAntiShadow) continue;
            bound_anti_shadow(stretches[i], i > 0 && stretches[i - 1].zone == kShadow,
                              i + 1 < count && stretches[i + 1].zone == kShadow);
        }
        for (int i = 0; i < count; ++i)
            if (stretches[i].zone == kFree)
                bound_free(stretches[i], i > 0, i + 1 < count);
        for (float& b : bound_) b = std::min(b, static_cast<float>(highest_));
    }

  private:
    // Algorithm 5: under the line of light that ends the shadow.
    void bound_shadow(const Stretch& s) {
        const int end = std::min(s.past, static_cast<int>(base_.size()) - 1);
        for (int i = s.first; i < s.past; ++i)
            bound_[i] = static_cast<float>(base_[end] + rise_ * (s.past - i));
    }

    // Algorithm 6: from the bound that is known at the start to the one that is known at
    // the end.
    void bound_anti_shadow(const Stretch& s, bool after_shadow, bool before_shadow) {
        const double start = after_shadow ? bound_[s.first - 1] : base_[s.first];
        const double end = before_shadow ? bound_[s.past] : highest_;
        interpolate(s, start, end);
    }

    // Algorithm 7; before the first anti-shadow as in the prose (docs/papers.md, Rusnell
    // 11).
    void bound_free(const Stretch& s, bool follows, bool leads) {
        if (follows && leads) {
            interpolate(s, bound_[s.first - 1], bound_[s.past]);
        } else if (follows) {
            interpolate(s, bound_[s.first - 1], highest_);
        } else if (leads) {
            for (int i = s.first; i < s.past; ++i)
                bound_[i] = static_cast<float>(base_[s.past] + rise_ * (s.past - i));
        } else {
            std::fill(bound_.begin() + s.first, bound_.begin() + s.past,
                      static_cast<float>(highest_));
        }
    }

    void interpolate(const Stretch& s, double start, double end) {
        for (int i = s.first; i < s.past; ++i) {
            const double f = (i - s.first + 0.5) / (s.past - s.first);
            bound_[i] = static_cast<float>(start + (end - start) * f);
        }
    }

    std::span<const float> base_;
    double rise_, highest_;
    std::span<float> bound_;
};

template <class T>
T nearest(const Field<T>& field, GridPoint p) {
    const Cell c = cell_of(p);
    return field(std::clamp(c.x, 0, field.width() - 1),
                 std::clamp(c.y, 0, field.height() - 1));
}

}  // namespace

Field<std::uint8_t> anti_shadow(const Field<std::uint8_t>& target, double reach) {
    const Field<float> distance = cells_inside(target, false);
    Field<std::uint8_t> band(target.width(), target.height());
    std::ranges::transform(distance, band.begin(), [reach](float d) {
        return static_cast<std::uint8_t>(d > 0.0f && d <= reach);
    });
    return band;
}

Field<float> height_bound(const Field<float>& base, const Field<std::uint8_t>& target,
                          const Field<std::uint8_t>& anti_shadow, double azimuth,
                          double rise, double highest) {
    const LightFrame frame = light_frame(base.width(), base.height(), azimuth, 1);
    Field<std::uint8_t> regions = rotated(anti_shadow, frame);
    const Field<std::uint8_t> shadows = rotated(target, frame);
    for (std::size_t i = 0; i < regions.size(); ++i)
        regions[i] = shadows[i] ? kShadow : regions[i] ? kAntiShadow : kFree;

    Field<float> turned(frame.side, frame.side);
    parallel_for(frame.side, 16, [&](int row) {
        std::vector<float> ground(frame.side);
        for (int i = 0; i < frame.side; ++i)
            ground[i] = nearest(base, frame.position(i, row));
        RowBound(regions.row(row), ground, rise, highest, turned.row(row));
    });

    Field<float> bound(base.width(), base.height());
    parallel_for(base.height(), 16, [&](int y) {
        for (int x = 0; x < base.width(); ++x) {
            const GridPoint p{static_cast<double>(x), static_cast<double>(y)};
            bound(x, y) = nearest(turned, {frame.sample_at(p), frame.row_at(p)});
        }
    });
    return bound;
}

}  // namespace cydonia::pareidolia
