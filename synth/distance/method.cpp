#include "synth/distance/distance.h"

#include <algorithm>

namespace cydonia::distance {

Method method_of(const Options&) {
    return {.name = "distance",
            .version = kVersion,
            .whole_because = "its paths cross the whole land"};
}

// Every thread keeps the costs of the feature that it works on. The passes of all
// features are remembered for the next run, up to a bound: once as they grow and once to
// be written.
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads) {
    constexpr std::uint64_t kMostPasses = 268'000'000;  // bytes
    const std::uint64_t passes = std::min(kMostPasses, 200 * cells);
    return cells * (80 + 25 * threads) + (options.preview ? 0 : 2 * passes);
}

}  // namespace cydonia::distance
