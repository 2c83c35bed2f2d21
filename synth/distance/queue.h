#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace cydonia::distance {

// A monotone priority queue of (cost, node) by buckets of a key (Dial 1969; Denardo and
// Fox 1979). The entries of a bucket come in the order in which they were pushed. This is
// exact for Dijkstra's algorithm when no edge is shorter than a bucket is wide, because
// then no entry of a bucket can improve another one in it. The buckets in use form a ring
// that is small enough for the processor's cache; entries beyond the ring wait in a heap.
class BucketQueue {
  public:
    struct Entry {
        float cost;
        int node;
    };

    // Prepares an empty queue whose buckets are `width` wide and begin at key 0.
    void reset(float width) { per_key_ = 1.0f / width; }

    void push(float key, float cost, int node) {
        // Rounding must not put the end of an edge into the bucket of its beginning.
        const auto bucket = std::max(static_cast<std::int64_t>(key * per_key_), next_);
        if (bucket - next_ < kReach) {
            put(bucket, {cost, node});
        } else {
            beyond_.push_back({bucket, {cost, node}});
            std::push_heap(beyond_.begin(), beyond_.end());
        }
    }

    // Calls visit(entry, upcoming) for every entry, bucket by bucket, including those
    // pushed meanwhile, and leaves the queue empty. `upcoming` is an entry that comes a
    // few entries later, or the last one of the bucket.
    template <class Visit>
    void drain(const Visit& visit) {
        next_ = 0;
        for (std::int64_t bucket = first(); bucket >= 0; bucket = first()) {
            next_ = bucket + 1;
            fetch_from_beyond();
            const std::vector<Entry>& entries = ring_[slot(bucket)];
            const std::size_t last = entries.size() - 1;
            for (std::size_t i = 0; i <= last; ++i) {
                visit(entries[i], entries[std::min(i + kAhead, last)]);
            }
            ring_[slot(bucket)].clear();
        }
        next_ = 0;
    }

  private:
    static constexpr std::int64_t kRing = 1024;        // a power of two
    static constexpr std::int64_t kReach = kRing - 1;  // the bucket being drained stays
    static constexpr std::size_t kAhead = 6;

    struct Late {
        std::int64_t bucket;
        Entry entry;
        bool operator<(const Late& other) const { return bucket > other.bucket; }
    };

    static std::size_t slot(std::int64_t bucket) {
        return static_cast<std::size_t>(bucket) % kRing;
    }

    void put(std::int64_t bucket, Entry entry) {
        ring_[slot(bucket)].push_back(entry);
        occupied_[slot(bucket) / 64] |= std::uint64_t{1} << (slot(bucket) % 64);
    }

    // The first bucket from next_ on that has entries, which it unmarks; -1 when none is
    // left.
    std::int64_t first() {
        const std::size_t from = slot(next_);
        for (std::size_t i = 0; i <= kRing / 64; ++i) {
            std::uint64_t& word = occupied_[(from / 64 + i) % (kRing / 64)];
            std::uint64_t here = word;
            if (i == 0) here &= ~std::uint64_t{0} << (from % 64);
            if (i == kRing / 64) here &= ~(~std::uint64_t{0} << (from % 64));
            if (here == 0) continue;
            const auto bit = static_cast<std::size_t>(std::countr_zero(here));
            word &= ~(std::uint64_t{1} << bit);
            const std::size_t found = (from / 64 + i) % (kRing / 64) * 64 + bit;
            return next_ + static_cast<std::int64_t>((found - from) % kRing);
        }
        if (beyond_.empty()) return -1;
        next_ = beyond_.front().bucket;
        fetch_from_beyond();
        return first();
    }

    void fetch_from_beyond() {
        while (!beyond_.empty() && beyond_.front().bucket - next_ < kReach) {
            std::pop_heap(beyond_.begin(), beyond_.end());
            put(beyond_.back().bucket, beyond_.back().entry);
            beyond_.pop_back();
        }
    }

    float per_key_ = 1.0f;
    std::int64_t next_ = 0;  // the first bucket that may still be put to
    std::array<std::vector<Entry>, kRing> ring_;
    std::array<std::uint64_t, kRing / 64> occupied_{};
    std::vector<Late> beyond_;  // a heap, the first bucket on top
};

}  // namespace cydonia::distance
