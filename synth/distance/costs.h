#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "field/field.h"
#include "synth/distance/curve.h"
#include "synth/distance/site.h"

namespace cydonia::distance {

struct CostRange {
    double least = 0.0, greatest = 1.0;
};

// The ranges of noises over the land that were measured so far.
using NoiseRanges = std::vector<std::pair<NoiseOptions, CostRange>>;

// C_g(n): a cost rule prepared for one group. Values may be negative because sums have
// such terms.
class CostPattern {
  public:
    // `reference` returns the cost that share_of names for one feature. Throws
    // bad_request, naming the group, for a rule that contradicts itself.
    using Reference = std::function<double(const CostRule&, const Shape&)>;
    CostPattern(const CostRule& rule, const std::string& group, const Site& site,
                Reference reference, NoiseRanges& noises, std::uint64_t purpose = 0);

    // From now on at() is asked about the i-th feature of the group.
    void enter(const Shape& shape, int i);
    double at(const SitePoint& place) const;

    // The rule's least and greatest value for the feature; bounds of them for sums and
    // minima.
    CostRange range() const {
        return {std::min(ends_[0], ends_[1]), std::max(ends_[0], ends_[1])};
    }

  private:
    double raw(const SitePoint& place) const;
    CostRange raw_range() const;
    double drawn_share(double along) const;

    CostRule rule_;
    const Site* site_;
    std::string group_;
    Reference reference_;
    std::uint64_t purpose_;  // separates the random numbers of two rules of a sum
    std::vector<CostPattern> of_;
    Field<float> painted_;
    std::vector<CurvePoint> drawn_;
    CostRange own_;  // the range of the pattern over the land

    // For the feature that was entered: the pattern's range, and the costs that its ends
    // become.
    CostRange source_;
    std::array<double, 2> ends_{};
    double random_ = 0.0;
    double begin_ = 0.0, deviation_ = 0.0;  // of the Gaussian, along its azimuth
    std::vector<float> along_;
};

// Sets the costs of all places, none below 0.
void set_costs(std::vector<Shape>& shapes, const Group& group, const Site& site,
               const CostPattern::Reference& reference, NoiseRanges& noises);

}  // namespace cydonia::distance
