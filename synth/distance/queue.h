#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace cydonia::distance {

// A monotone priority queue of (cost, node), least first, equal costs by node: exact for
// any edge weights. Costs lie in a ring of narrow buckets; only the bucket in use is kept
// as a heap, a few entries long. What lies beyond the ring waits apart.
class BucketQueue {
  public:
    // A good width leaves a few entries to a bucket; any width gives the same order.
    explicit BucketQueue(float bucket_width) : per_cost_(1.0f / bucket_width) {
        heads_.fill(kNone);
    }

    // cost >= 0 and not below the last one popped.
    void push(float cost, int node) { place({cost, node, kNone}); }

    struct Entry {
        float cost;
        int node;
        int next;
    };

    // False when empty.
    bool pop(float& cost, int& node) {
        if (heap_.empty() && !refill()) return false;
        std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
        const std::uint64_t least = heap_.back();
        heap_.pop_back();
        cost = std::bit_cast<float>(static_cast<std::uint32_t>(least >> 32));
        node = static_cast<int>(least & 0xffffffffu);
        return true;
    }

  private:
    static constexpr int kNone = -1;
    static constexpr int kBuckets = 4096;
    static constexpr int kWords = kBuckets / 64;

    // Costs are not negative, so their bits order as they do.
    static std::uint64_t key(float cost, int node) {
        return std::uint64_t{std::bit_cast<std::uint32_t>(cost)} << 32 |
               static_cast<std::uint32_t>(node);
    }

    void place(Entry entry) {
        const float place = (entry.cost - base_) * per_cost_;
        if (!(place < static_cast<float>(kBuckets))) {
            beyond_.push_back(entry);
            return;
        }
        const int bucket = static_cast<int>(place);
        if (bucket <= current_) {
            heap_.push_back(key(entry.cost, entry.node));
            std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
            return;
        }
        entry.next = heads_[bucket];
        heads_[bucket] = taken(entry);
        occupied_[bucket / 64] |= std::uint64_t{1} << (bucket % 64);
    }

    // A free place in the pool, filled.
    int taken(const Entry& entry) {
        if (free_ == kNone) {
            pool_.push_back(entry);
            return static_cast<int>(pool_.size()) - 1;
        }
        const int slot = free_;
        free_ = pool_[slot].next;
        pool_[slot] = entry;
        return slot;
    }

    bool refill() {
        int bucket = next_occupied();
        if (bucket == kNone) {
            if (beyond_.empty()) {
                restart();
                return false;
            }
            advance();
            if (!heap_.empty()) return true;
            bucket = next_occupied();
        }
        current_ = bucket;
        occupied_[bucket / 64] &= ~(std::uint64_t{1} << (bucket % 64));
        for (int slot = heads_[bucket]; slot != kNone;) {
            Entry& entry = pool_[slot];
            heap_.push_back(key(entry.cost, entry.node));
            const int next = entry.next;
            entry.next = free_;
            free_ = slot;
            slot = next;
        }
        heads_[bucket] = kNone;
        std::make_heap(heap_.begin(), heap_.end(), std::greater<>());
        return true;
    }

    int next_occupied() const {
        for (int word = std::max(current_, 0) / 64; word < kWords; ++word) {
            if (occupied_[word]) return word * 64 + std::countr_zero(occupied_[word]);
        }
        return kNone;
    }

    // Lays the ring from the least cost that waits beyond it.
    void advance() {
        base_ = std::min_element(
                    beyond_.begin(), beyond_.end(),
                    [](const Entry& a, const Entry& b) { return a.cost < b.cost; })
                    ->cost;
        current_ = kNone;
        std::vector<Entry> waiting;
        waiting.swap(beyond_);
        for (const Entry& entry : waiting) place(entry);
    }

    void restart() {
        base_ = 0.0f;
        current_ = kNone;
    }

    float per_cost_;
    float base_ = 0.0f;    // cost where bucket 0 begins
    int current_ = kNone;  // the bucket whose entries are in the heap
    int free_ = kNone;
    std::array<int, kBuckets> heads_;
    std::array<std::uint64_t, kWords> occupied_{};
    std::vector<Entry> pool_;  // lists of the buckets, linked by index
    std::vector<Entry> beyond_;
    std::vector<std::uint64_t> heap_;
};

}  // namespace cydonia::distance
