#include "synth/dem/dem.h"

namespace cydonia::dem {

Method method_of(const Options&) {
    return {.name = "dem", .version = kVersion, .whole_because = "it is one model"};
}

// The whole model is read.
std::uint64_t peak_memory(const Options& options, std::uint64_t cells, std::uint64_t) {
    return 24 * model_cells(options.source) + 16 * cells;
}

}  // namespace cydonia::dem
