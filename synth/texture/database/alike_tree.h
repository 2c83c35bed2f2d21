#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cydonia::texture {

// A place on an exemplar, and what its neighbourhood looks like in few numbers.
inline constexpr int kTraits = 8;
using Traits = std::array<float, kTraits>;
struct Sample {
    Traits traits;
    std::uint32_t exemplar;
    std::uint16_t x, y;
};

// Finds samples of traits near the asked ones: a k-d tree, its leaves in one array.
class AlikeTree {
  public:
    // The same for any number of threads.
    explicit AlikeTree(std::vector<Sample> samples);

    // The samples of the leaf that these traits fall into; none when there are none.
    std::span<const Sample> around(const Traits& traits) const;

  private:
    struct Node {
        int axis;
        float split;  // the upper side: at least this
    };
    static constexpr int kLeaf = 24;  // samples, at most

    void grow(std::size_t node, std::span<Sample> samples);

    std::vector<Sample> samples_;
    std::vector<Node> nodes_;  // the children of i are 2 i + 1 and 2 i + 2
    int depth_ = 0;
};

}  // namespace cydonia::texture
