#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "synth/genetic/evolution/chromosome.h"
#include "synth/genetic/evolution/fitness.h"
#include "synth/genetic/options.h"
#include "synth/texture/constraints/guidance.h"
#include "synth/texture/constraints/window.h"

namespace cydonia::genetic {

// The height field of one level, with its genes.
struct Encoded {
    const GeneGrid* grid;
    const LevelSamples* samples;
    const Chromosome* genes;
    const Field<float>* heights;
};

// Makes the finer levels by parallel texture synthesis (Gain 2015) instead of genes. It
// starts with the origin that the genes give each cell, and keeps to the map's types.
// Seams are much less visible, because single cells choose their land and not whole
// chunks.
class ByTexture {
  public:
    // `used` tells for each type of the library whether it is used; at most as many may
    // be as the texture method can tell apart. `spacing` is that of the finest cells,
    // metres. The exemplars' database is kept in `cache`. Throws bad_request.
    ByTexture(const LibraryOptions& library, const std::vector<std::uint8_t>& used,
              double spacing, const std::filesystem::path& cache, Progress& progress);
    ~ByTexture();

    // `types` are those of the finest cells, as indices in the library. The result has
    // the same cells.
    Field<float> refined(const Encoded& coarse, const Field<std::uint8_t>& types,
                         std::uint64_t seed, Progress& progress) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace cydonia::genetic
