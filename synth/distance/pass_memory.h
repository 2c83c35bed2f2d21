#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "synth/distance/passes.h"

namespace cydonia::distance {

// The passes of a run, kept for the next: a stroke that changes then costs little more
// than itself. A feature's pass is the same again when nothing under it changed - edges,
// profiles, sea level, thresholds, its own generators - but where it goes on now and
// stopped then or the other way round, which is mended. (Rusnell 2009, section 6.2,
// iterative refinement.)
class PassMemory {
  public:
    // `bytes` of an earlier run, or none; those that are damaged or of another ground
    // count as none.
    PassMemory(const Ground& ground, const Halting& halting, std::string bytes);

    // The pass that pass_of() would find, if it is known. Thread-safe.
    std::optional<Pass> recalled(int feature, std::span<const float> approximate,
                                 LeastCost& paths) const;
    // In the order of features; of passes with labels.
    void keep(int feature, const Pass& pass, std::span<const float> approximate);
    // What was kept, for the next run; empty when it was too much. Once.
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
