#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "synth/context.h"
#include "synth/distance/options.h"
#include "synth/distance/passes.h"

namespace cydonia::distance {

// Shows how a stage computed its land, as pictures of the graph's samples and a table:
//   features, profiles, costs   of the generators
//   approximate                 the field of steps 5 and 6
//   search-<feature>            where a feature's pass went and why it halted (Rusnell
//                               2009, figure 3.8), for up to kSearches features
//   visits                      how many passes came to each sample
//   highest                     the feature that is highest there
//   features.csv                a line a feature
// All of it depends on the scene alone, not on threads, memory or time.
class Explainer {
  public:
    static constexpr int kSearches = 12;

    // Shows the generators and the approximate field. All arguments must outlive this
    // object.
    Explainer(const Explain& sinks, const Options& options, const Ground& ground,
              const Halting& halting, const std::vector<float>& approximate);

    // Receives step 7a of every feature, in the features' order.
    void pass(int feature, const Pass& pass);
    // Must be called after the last pass.
    void finish();

  private:
    enum : int { kSea = 1, kBelow = 2 };  // why a pass went no further; may be both
    int halt_of(int node, float height) const;
    bool shown(int feature) const;
    void show_generators();
    void show_search(int feature, const Pass& pass);
    void add_line(int feature, const Pass& pass);
    std::string name_of_group(int group) const;

    const Explain& sinks_;
    const Options& options_;
    const Ground& ground_;
    const Halting& halting_;
    const std::vector<float>& approximate_;
    std::vector<int> highest_;           // by node: a feature, or -1
    std::vector<float> height_;          // by node, of that feature
    std::vector<std::uint32_t> visits_;  // by node
    std::string table_;
};

// A colour for a number; neighbouring numbers have colours that are easy to tell apart.
Rgb8 distinct_colour(int number);

// The colours of figure 3.8.
inline constexpr Rgb8 kAtSea{40, 80, 220}, kFarBelow{214, 40, 40}, kBoth{30, 160, 60};
inline constexpr Rgb8 kGenerator{0, 0, 0}, kSearched{236, 226, 196};
inline constexpr Rgb8 kElsewhere{255, 255, 255};

}  // namespace cydonia::distance
