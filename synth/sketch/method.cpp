#include "synth/sketch/sketch.h"

#include <algorithm>

#include "synth/texture/texture.h"

namespace cydonia::sketch {

Method method_of(const Options&) {
    return {.name = "sketch",
            .version = kVersion,
            .whole_because = "its landforms are as large as they are drawn"};
}

// All scales of the land, footprints as large as the land, and copies of the land under
// landforms through which others are seen. Noise of real land is made like land.
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads) {
    constexpr std::uint64_t kDrawings = 64'000'000;  // bytes
    const bool seen_through =
        std::ranges::any_of(options.features, [](const Feature& feature) {
            return feature.view && !feature.view->through.empty();
        });
    const auto levels = static_cast<std::uint64_t>(options.levels);
    std::uint64_t noise = 0;
    if (options.noise != NoiseKind::kWavelet && options.noise_from) {
        texture::Options land;
        land.exemplars.push_back({*options.noise_from, {}, {}});
        noise = options.noise == NoiseKind::kTexture
                    ? texture::peak_memory(land, cells, threads)
                    : 40 * cells + 8 * levels * cells;
    }
    return (120 + 4 * levels + (seen_through ? 32 : 0)) * cells + noise + kDrawings;
}

}  // namespace cydonia::sketch
