#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <vector>

namespace cydonia::distance {

// A monotone priority queue of (cost, node), least first, equal costs by node: exact for
// any edge weights. Costs lie in a ring of narrow buckets; only the bucket in use is kept
// in order, a few entries long. What lies beyond the ring waits apart.
class BucketQueue {
  public:
    // A good width leaves a few entries to a bucket; any width gives the same order.
    explicit BucketQueue(float bucket_width)
        : per_cost_(1.0f / bucket_width), buckets_(kBuckets) {}

    // cost >= 0 and not below the last one popped.
    void push(float cost, int node) {
        const float place = (cost - base_) * per_cost_;
        if (!(place < static_cast<float>(kBuckets))) {
            beyond_.push_back(key(cost, node));
            return;
        }
        const int bucket = static_cast<int>(place);
        if (bucket > current_) {
            buckets_[bucket].push_back(key(cost, node));
            occupied_[bucket / 64] |= std::uint64_t{1} << (bucket % 64);
        } else {
            late_.push_back(key(cost, node));
            std::push_heap(late_.begin(), late_.end(), std::greater<>());
        }
    }

    // The least entry, false when none is left. Entries for which alive(cost, node) is
    // false may be dropped on the way: most of those that a lower label has overtaken are
    // never sorted, which halves a pass' time.
    template <class Alive>
    bool pop(float& cost, int& node, const Alive& alive) {
        while (sorted_.empty() && late_.empty()) {
            if (!refill(alive)) return false;
        }
        std::uint64_t least = 0;
        if (late_.empty() || (!sorted_.empty() && sorted_.back() < late_.front())) {
            least = sorted_.back();
            sorted_.pop_back();
        } else {
            std::pop_heap(late_.begin(), late_.end(), std::greater<>());
            least = late_.back();
            late_.pop_back();
        }
        cost = cost_of(least);
        node = node_of(least);
        return true;
    }

  private:
    static constexpr int kBuckets = 4096;

    // Costs are not negative, so their bits order as they do.
    static std::uint64_t key(float cost, int node) {
        return std::uint64_t{std::bit_cast<std::uint32_t>(cost)} << 32 |
               static_cast<std::uint32_t>(node);
    }
    static float cost_of(std::uint64_t key) {
        return std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32));
    }

    static int node_of(std::uint64_t key) { return static_cast<int>(key & 0xffffffffu); }

    // Puts the next bucket in order. An empty queue is ready for another pass.
    template <class Alive>
    bool refill(const Alive& alive) {
        int bucket = next_occupied();
        if (bucket < 0) {
            current_ = -1;
            base_ = 0.0f;
            if (beyond_.empty()) return false;
            lay_ring_from_beyond();
            bucket = next_occupied();
        }
        current_ = bucket;
        occupied_[bucket / 64] &= ~(std::uint64_t{1} << (bucket % 64));
        sorted_.swap(buckets_[bucket]);
        std::size_t kept = 0;
        for (std::uint64_t k : sorted_) {
            sorted_[kept] = k;
            kept += alive(cost_of(k), node_of(k)) ? 1 : 0;
        }
        sorted_.resize(kept);
        std::sort(sorted_.begin(), sorted_.end(), std::greater<>());
        return true;
    }

    int next_occupied() const {
        for (int word = std::max(current_, 0) / 64; word < kBuckets / 64; ++word) {
            if (occupied_[word]) return word * 64 + std::countr_zero(occupied_[word]);
        }
        return -1;
    }

    void lay_ring_from_beyond() {
        base_ = cost_of(*std::min_element(beyond_.begin(), beyond_.end()));
        std::vector<std::uint64_t> waiting;
        waiting.swap(beyond_);
        for (std::uint64_t k : waiting) push(cost_of(k), node_of(k));
    }

    float per_cost_;
    float base_ = 0.0f;  // cost where bucket 0 begins
    int current_ = -1;   // the bucket in order
    std::vector<std::vector<std::uint64_t>> buckets_;
    std::array<std::uint64_t, kBuckets / 64> occupied_{};
    std::vector<std::uint64_t> sorted_;  // the bucket in use, least last
    std::vector<std::uint64_t> late_;    // a heap of what came into it since
    std::vector<std::uint64_t> beyond_;
};

}  // namespace cydonia::distance
