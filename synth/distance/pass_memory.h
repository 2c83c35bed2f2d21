#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "synth/distance/passes.h"

namespace cydonia::distance {

// Keeps the passes of a run for the next one, so that after a stroke has changed little
// more than that stroke's own passes is computed. The pass of a feature is the same again
// when nothing that it depends on has changed: edges, profiles, sea level, thresholds and
// its own generators. Where it goes on now and stopped before, or the other way round, it
// is corrected. (Rusnell 2009, section 6.2,
// iterative refinement.)
class PassMemory {
  public:
    // `bytes` come from taken_bytes() of an earlier run, or are empty. Bytes that are
    // damaged or of another ground are ignored.
    PassMemory(const Ground& ground, const Halting& halting, std::string bytes);

    // The pass that pass_of() would find, when it is known. Thread-safe.
    std::optional<Pass> recalled(int feature, std::span<const float> approximate,
                                 LeastCost& paths) const;
    // Keeps a pass with labels. To be called in the order of the features.
    void keep(int feature, const Pass& pass, std::span<const float> approximate);
    // The bytes for the next run; empty when they would be too many. To be called once.
    std::string taken_bytes();

  private:
    void index_known(std::string_view body);
    std::uint64_t key_of(int feature) const;
    std::vector<std::uint8_t> own_sides(int feature) const;
    std::optional<LeastCost::Trace> trace_of(int feature) const;

    const Ground& ground_;
    Halting halting_;
    std::uint64_t ground_key_;
    std::string known_bytes_;
    std::map<std::uint64_t, std::string_view>
        known_;  // by feature's key, in known_bytes_
    std::string kept_;
    bool overflowed_ = false;
};

}  // namespace cydonia::distance
