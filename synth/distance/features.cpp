#include "synth/distance/features.h"

#include "field/error.h"

namespace cydonia::distance {

Features features_of(const Options&, const Graph&, const Terrain&, std::uint64_t) {
    throw failure("groups of features: not built yet");
}

}  // namespace cydonia::distance
