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

// A height field of one level with its genes.
struct Encoded {
    const GeneGrid* grid;
    const LevelSamples* samples;
    const Chromosome* genes;
    const Field<float>* heights;
};

// The other optimiser: the finer levels by parallel texture synthesis (Gain 2015), which
// starts from what the genes say where each cell's land is from, and keeps to the map's
// types. Much less to be seen of seams, as cells choose and not chunks of them.
class ByTexture {
  public:
    // `used`: of the library's types, as many as texture can tell apart. `spacing`: of
    // its finest cells, metres. Exemplars are kept in `cache`. Throws bad_request.
    ByTexture(const LibraryOptions& library, const std::vector<std::uint8_t>& used,
              double spacing, const std::filesystem::path& cache, Progress& progress);
    ~ByTexture();

    // Types of the finest cells, in the library; the result has the same cells.
    Field<float> refined(const Encoded& coarse, const Field<std::uint8_t>& types,
                         std::uint64_t seed, Progress& progress) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace cydonia::genetic
