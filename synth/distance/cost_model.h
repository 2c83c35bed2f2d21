#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "field/field.h"
#include "synth/distance/dijkstra.h"
#include "synth/distance/profile.h"

namespace cydonia::distance {

// The sum of raw edge weights, without a profile.
struct RawCostModel {
    std::span<const Start> starts;

    static constexpr bool kOneWay = true;

    Label begin(int origin) const { return {.cost = starts[origin].cost}; }
    auto from(int /*node*/, const Label& label) const {
        return [cost = starts[label.origin].cost](int, int, float length) {
            return Label{.cost = cost + length, .length = length};
        };
    }
    float key(float cost) const { return cost; }
    float least_step(float edge) const { return edge; }
};

// A constant profile for each start: the weight of every edge of a path is multiplied by
// its origin's factor.
struct ConstantCostModel {
    std::span<const Start> starts;
    std::span<const float> factors;  // as many as starts, each > 0

    static constexpr bool kOneWay = true;

    Label begin(int origin) const { return {.cost = starts[origin].cost}; }
    auto from(int /*node*/, const Label& label) const {
        return [cost = starts[label.origin].cost, factor = factors[label.origin]](
                   int, int, float length) {
            return Label{.cost = cost + factor * length, .length = length};
        };
    }
    float key(float cost) const { return cost; }
    float least_step(float edge) const {
        return factors.empty() ? edge : edge * *std::ranges::min_element(factors);
    }
};

// The profiles of a stage, and where each of them holds, prepared for the passes.
struct Shapes {
    static constexpr std::uint8_t kOwn = 255;

    double sea_level = 0.0;            // c_s
    double mean_edge_weight = 1.0;     // mu_w
    std::vector<Descent> descents{};   // by way; none: raw edge weights
    std::vector<std::uint8_t> ways{};  // the descent of each start
    // When features have two sides: the descent of each start on the far side of its
    // stroke. `beside` gives, for the nodes within kBeside cells of a stroke (more than a
    // step), the feature of that stroke, and -1 elsewhere; `side_at` is 1 on the far
    // side.
    static constexpr int kBeside = 3;
    std::vector<std::uint8_t> other_ways{};
    std::vector<int> feature_of{};  // each start
    std::vector<int> beside{};
    std::vector<std::uint8_t> side_at{};
    // When there are regions: the descent that holds at each node; kOwn is the feature's
    // own.
    std::vector<std::uint8_t> way_at{};
    std::vector<std::uint8_t> region_ways{};  // all that way_at has, but kOwn

    bool raw() const { return descents.empty(); }
    bool plain() const { return other_ways.empty() && way_at.empty(); }
};

// Fills `beside` and `side_at` from the starts' unit vectors, which point into their
// first side. A start whose vector is zero has no sides.
void lay_sides(Shapes& shapes, const Graph& graph, std::span<const Start> starts,
               std::span<const std::array<float, 2>> sides);

// A key for the queue that rises evenly where cost rises unevenly. Along every path it
// rises by at least the length of the path, whatever profile it follows: at each cost the
// key's slope is the reciprocal of the least slope that a path of these starts can have
// there.
class EvenKey {
  public:
    // `first` is the index of the first of `starts` in `shapes`.
    EvenKey(const Shapes& shapes, std::span<const Start> starts, int first);

    float operator()(float cost) const {
        const float place = (cost - first_) * per_cost_;
        if (!(place < kBins)) return keys_[kBins] + beyond_ * (place - kBins);
        const int bin = static_cast<int>(place);
        const float t = place - static_cast<float>(bin);
        return keys_[bin] + t * (keys_[bin + 1] - keys_[bin]);
    }

  private:
    static constexpr int kBins = 256;
    float first_ = 0.0f;  // the least cost of a start
    float per_cost_ = 0.0f;
    float beyond_ = 0.0f;  // a bin past sea level
    std::array<float, kBins + 1> keys_{};
};

// The cost along profiles: eq. 3.4 to 3.6 integrated along the path. By eq. 3.6 every
// generator shows the whole profile; where it starts lower the profile is smaller, with
// the same slopes over a shorter way. Lengths are sums of raw edge weights, of which
// mean_edge_weight make a metre.
class ProfileCostModel {
  public:
    static constexpr bool kOneWay = true;

    // All `starts` must cost less than sea level. Their ways are in `shapes` from index
    // `first` on. Both must outlive this object.
    ProfileCostModel(const Shapes& shapes, std::span<const Start> starts, int first);

    Label begin(int origin) const { return {.cost = starts_[origin].cost}; }
    auto from(int /*node*/, const Label& label) const {
        const float cost = starts_[label.origin].cost, share = share_of(cost);
        return [descent = &descents_[ways_[label.origin]], cost, share,
                rate = metres_ / share](int, int, float length) {
            return Label{.cost = cost + share * (*descent)(rate * length),
                         .length = length};
        };
    }
    float key(float cost) const { return key_(cost); }
    float least_step(float edge) const { return metres_ * edge; }

  protected:
    float share_of(float cost) const { return (sea_level_ - cost) * per_sea_level_; }

    const Descent* descents_;
    const std::uint8_t* ways_;
    std::span<const Start> starts_;
    float metres_;                     // of ground for one of path length: 1 / mu_w
    float sea_level_, per_sea_level_;  // c_s and 1 / c_s
    EvenKey key_;
};

// The next larger float. `cost` must be finite and not negative.
inline float just_above(float cost) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(cost) + 1);
}

// The same where the profile changes along the path: beside its own stroke a path takes
// the profile of that side, and in a region the region's. It continues at the height at
// which it entered.
class ChangingCostModel : public ProfileCostModel {
  public:
    static constexpr bool kOneWay = false;

    ChangingCostModel(const Shapes& shapes, std::span<const Start> starts, int first);

    Label begin(int origin) const {
        return {.cost = starts_[origin].cost, .way = ways_[origin]};
    }
    auto from(int /*node*/, const Label& label) const {
        return [this, label, cost = starts_[label.origin].cost,
                share = share_of(starts_[label.origin].cost)](
                   int /*direction*/, int neighbour, float length) {
            Label there = label;
            there.side = side_at(neighbour, label);
            there.way = way_at(neighbour, label.origin, there.side);
            there.length = length;
            const float rate = metres_ / share;
            if (there.way != label.way) {
                const float down = (label.cost - cost) / share;
                there.length +=
                    descents_[there.way].distance_at(down) / rate - label.length;
            }
            there.cost =
                std::max(just_above(label.cost),
                         cost + share * descents_[there.way](rate * there.length));
            return there;
        };
    }

  private:
    std::uint8_t side_at(int node, const Label& label) const {
        if (other_ways_ == nullptr || shapes_->beside[node] < 0) return label.side;
        const int feature = shapes_->feature_of[first_ + label.origin];
        const bool own = shapes_->beside[node] == feature;
        return own ? shapes_->side_at[node] : label.side;
    }
    std::uint8_t way_at(int node, int origin, std::uint8_t side) const {
        if (!way_at_.empty() && way_at_[node] != Shapes::kOwn) return way_at_[node];
        return side == 0 ? ways_[origin] : other_ways_[origin];
    }

    const std::uint8_t* other_ways_;  // null without sides
    std::span<const std::uint8_t> way_at_;
    const Shapes* shapes_;
    int first_;
};

}  // namespace cydonia::distance
