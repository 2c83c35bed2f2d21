#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "field/progress.h"
#include "synth/genetic/evolution/chromosome.h"
#include "synth/genetic/evolution/fitness.h"
#include "synth/genetic/options.h"

namespace cydonia::genetic {

// Figures of a population after a cycle: of the best chromosome, unless said otherwise.
struct Generation {
    double fitness = 0.0;        // eq. IV.13
    double compatibility = 0.0;  // mean over genes
    double similarity = 0.0;     // mean over regions by area
    double mean_fitness = 0.0;   // of the population
};

struct Evolved {
    Chromosome best;
    std::vector<Generation> generations;  // the first one before any cycle
};

// The height field genetic algorithm (section IV.3.3). `inherited` has for each slot the
// gene that continues the coarser level's land there, if there is one. The result is the
// same for any number of threads.
Evolved evolved(const Fitness& fitness, const std::vector<std::optional<Gene>>& inherited,
                const EvolutionOptions& options, std::uint64_t seed, Progress& progress);

}  // namespace cydonia::genetic
