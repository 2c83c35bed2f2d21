#pragma once

#include <array>
#include <span>
#include <vector>

#include "synth/distance/dijkstra.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// A profile turned over, scaled to sea level and tabulated: cost by horizontal distance
// from a generator of cost 0, strictly increasing from (0, 0).
struct Descent {
    double sea_level = 0.0;    // c_s, metres; the last of `costs`
    double reach = 0.0;        // metres at which the cost is c_s
    std::vector<float> costs;  // at equal distances from 0 to `reach`
    float beyond = 0.0f;       // slope past the reach

    float operator()(float distance) const {
        const float place = distance * per_metre;
        const auto last = static_cast<float>(costs.size() - 1);
        if (!(place < last)) {
            return costs.back() + beyond * (distance - static_cast<float>(reach));
        }
        const int i = static_cast<int>(place);
        const float t = place - static_cast<float>(i);
        return costs[i] + t * (costs[i + 1] - costs[i]);
    }
    float per_metre = 0.0f;  // table places a metre
};

// The cost line of every profile of the options. See descent_of.
std::vector<Descent> descents_of(const Options& options, double sea_level, double width);

// Rusnell 2009, section 3.3.1. Points with the same height count as one slope, the mean
// over their run; slopes below minimum_scale * mean_edge_weight are interpolated from the
// nearest steeper ones on both sides. `width` is the terrain's, metres. Throws
// bad_request, saying where, for a profile that rises, is flat, or has fewer than two
// points.
Descent descent_of(const Profile& profile, double sea_level, double mean_edge_weight,
                   double minimum_scale, double width);

// Growth of cost (synth/distance/dijkstra.h) along a profile: eq. 3.4 to 3.6 integrated
// along the path. By eq. 3.6 every generator shows the whole profile, smaller where it
// starts lower: the same slopes over a shorter way.
class ProfileGrowth {
  public:
    // `starts` below sea level cost; both outlive this.
    ProfileGrowth(const Descent& descent, std::span<const Start> starts,
                  double mean_edge_weight);

    auto from(int origin) const {
        const float share = shares_[origin];
        return [descent = descent_, cost = starts_[origin].cost, share,
                rate = distance_ / share](float length) {
            return cost + share * (*descent)(rate * length);
        };
    }

  private:
    const Descent* descent_;
    std::span<const Start> starts_;
    std::vector<float> shares_;  // (c_s - c_ng) / c_s of each start
    float distance_;             // metres of ground for one of path length: 1 / mu_w
};

}  // namespace cydonia::distance
