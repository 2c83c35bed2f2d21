#include "synth/dem/dem.h"

namespace cydonia::dem {

Method method_of(const Options&) {
    return {.name = "dem", .version = kVersion, .whole_because = "it is one model"};
}

// The model is read whole; our own exr files pack a height into a byte at best.
std::uint64_t peak_memory(const Options& options, std::uint64_t cells, std::uint64_t) {
    return 24 * model_cells(options.source) + 16 * cells;
}

}  // namespace cydonia::dem
