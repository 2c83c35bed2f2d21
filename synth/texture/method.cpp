#include "synth/texture/texture.h"

#include <algorithm>

namespace cydonia::texture {

Method method_of(const Options& options) {
    const auto whole_because = [&]() -> std::string_view {
        if (options.breach) return "breach follows channels across the whole land";
        if (options.coherent) return "coherent keeps to the whole land of the last run";
        return {};
    };
    return {.name = "texture",
            .version = kVersion,
            .whole_because = whole_because(),
            .follows_memory = options.coherent};
}

// Measured: 117 bytes a cell of the exemplars while they are prepared, then 56 a cell of
// the land, or 191 where the passes of the last run and of this one are kept.
std::uint64_t peak_memory(const Options& options, std::uint64_t cells, std::uint64_t) {
    std::uint64_t exemplars = 0;
    for (const Exemplar& exemplar : options.exemplars)
        exemplars += model_cells(exemplar.source);
    return std::max(130 * exemplars,
                    43 * exemplars + (options.coherent ? 215 : 80) * cells) +
           4 * options.types.size() * cells;
}

int reach(const Options&, const Extent&) { return 128; }

}  // namespace cydonia::texture
