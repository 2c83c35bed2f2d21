#include "synth/detail/detail.h"

namespace cydonia::detail {

Method method_of(const Options& options) {
    const auto whole_because = [&]() -> std::string_view {
        if (options.search == Search::kPatchMatch)
            return "PatchMatch goes on from block to block; search = \"random\" does not";
        if (options.paint || !options.mappings.empty())
            return "paint and mappings lie over the whole land";
        return {};
    };
    return {.name = "detail",
            .version = kVersion,
            .whole_because = whole_because(),
            .makes_land = false};
}

// The land with its own details, those that are quilted and the result; the targets with
// their details, in every orientation.
std::uint64_t peak_memory(const Options& options, std::uint64_t cells, std::uint64_t) {
    std::uint64_t targets = 0;
    for (const Target& target : options.targets) targets += model_cells(target.source);
    const std::uint64_t copies = static_cast<std::uint64_t>(options.orientations);
    return (40 + (options.mappings.empty() && !options.paint ? 0 : 8)) * cells +
           (24 + 16 * copies) * targets;
}

}  // namespace cydonia::detail
