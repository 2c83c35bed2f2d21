#include "synth/pareidolia/pareidolia.h"

#include <algorithm>

#include "field/image.h"

namespace cydonia::pareidolia {
namespace {

// A picture's own pixels, and those that a drawing or two tones of it are drawn with.
std::uint64_t of_image(const ImageOptions& image, std::uint64_t cells) {
    constexpr std::uint64_t kFinest = std::uint64_t{4096} * 4096;
    const std::uint64_t own = image.target ? pixels_of(*image.target) : 0;
    const std::uint64_t drawn = own > 0 ? own : 16 * cells;
    return 8 * own + 20 * std::min(drawn, kFinest) + 16 * cells;
}

}  // namespace

Method method_of(const Options&) {
    return {.name = "pareidolia",
            .version = kVersion,
            .whole_because = "its shadows fall across the whole land"};
}

// Reading an image comes before solving for all of them.
std::uint64_t peak_memory(const Options& options, std::uint64_t cells, std::uint64_t) {
    // Rows of light follow the mesh with up to four samples a cell.
    const bool rows = options.solver == Solver::kConstrained;
    std::uint64_t needed = (rows ? 180 + 200 * options.images.size() : 160) * cells;
    for (const ImageOptions& image : options.images)
        needed = std::max(needed, of_image(image, cells));
    return needed;
}

}  // namespace cydonia::pareidolia
