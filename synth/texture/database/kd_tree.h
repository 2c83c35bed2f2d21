#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cydonia::texture {

// A cell of an exemplar, and a few numbers that describe its neighbourhood.
inline constexpr int kTraits = 8;
using Traits = std::array<float, kTraits>;
struct Sample {
    Traits traits;
    std::uint32_t exemplar;
    std::uint16_t x, y;
};

// A k-d tree of samples by their traits. All its leaves lie in one array.
class KdTree {
  public:
    // The tree is the same for any number of threads.
    explicit KdTree(std::vector<Sample> samples);

    // The samples in the leaf that contains these traits; none in an empty tree.
    std::span<const Sample> around(const Traits& traits) const;

  private:
    struct Node {
        int axis;
        float split;  // traits of at least this are on the upper side
    };
    static constexpr int kLeaf = 24;  // samples, at most

    void grow(std::size_t node, std::span<Sample> samples);

    std::vector<Sample> samples_;
    std::vector<Node> nodes_;  // the children of i are 2 i + 1 and 2 i + 2
    int depth_ = 0;
};

}  // namespace cydonia::texture
