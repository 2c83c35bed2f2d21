#pragma once

#include <array>
#include <string>
#include <vector>

#include "field/source.h"

namespace cydonia::genetic {

// Real land of one type, or a part of it: shares from its south-west corner, west, south,
// east and north.
struct Example {
    Source source;
    std::array<double, 4> window{0.0, 0.0, 1.0, 1.0};
    // As land it is stretched sideways by `scale`, its heights by `vertical_scale`, and
    // `raise` metres higher.
    double scale = 1.0, vertical_scale = 1.0, raise = 0.0;
};

// A type of land by examples (Saunders 2006, section IV.2.1).
struct TypeOptions {
    std::string name;
    std::vector<Example> examples;
};

// A terrain library: kinds of land as people think of them.
struct LibraryOptions {
    std::string name;
    std::vector<TypeOptions> types;
    // Levels of detail, metres from sample to sample, coarse to fine.
    std::vector<double> levels = {810.0, 270.0, 90.0, 30.0, 10.0};
};

// Of the height field genetic algorithm (section IV.3.3; defaults as notes and measures
// have them).
struct EvolutionOptions {
    int gene = 16;         // cells
    double overlap = 0.3;  // of a gene's side
    int population = 15, cycles = 15;
    double mutation = 0.5;                   // P_m of eq. IV.15
    double elitism = 0.2, selection = 0.75;  // shares of the population
    double alpha = 0.5;                      // of eq. IV.13
    int crossed = 8;  // genes across, at most, that a crossover copies
};

}  // namespace cydonia::genetic
