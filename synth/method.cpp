#include "synth/method.h"

#include "field/dem.h"

namespace cydonia {

std::uint64_t model_cells(const Source& source) {
    constexpr std::uint64_t kMost = std::uint64_t{16384} * 16384;
    return std::min(kMost, samples_of_dem(source).value_or(source.size));
}

}  // namespace cydonia
