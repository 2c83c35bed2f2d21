#include "synth/genetic/genetic.h"

#include "synth/texture/texture.h"

namespace cydonia::genetic {

Method method_of(const Options&) {
    return {.name = "genetic",
            .version = kVersion,
            .whole_because = "its regions are judged as wholes"};
}

// A population of heights and their statistics, all samples of the library at all levels,
// and what texture knows of them.
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads) {
    texture::Options land;
    std::uint64_t examples = 0;
    for (const TypeOptions& type : options.library.types)
        for (const Example& example : type.examples) {
            land.exemplars.push_back({example.source, {}, {}});
            examples += model_cells(example.source);
        }
    const auto types = static_cast<std::uint64_t>(options.library.types.size());
    const auto population = static_cast<std::uint64_t>(options.evolution.population);
    return 60 * examples + texture::peak_memory(land, cells, threads) +
           (60 + 8 * types + 20 * population) * cells;
}

}  // namespace cydonia::genetic
