#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "field/source.h"
#include "synth/geometry/options.h"

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
    std::array<std::uint8_t, 3> colour{};  // that stands for it in pictures and maps
};

// How boundaries between two types are refined (section V.3.3.4).
struct Seam {
    std::string a, b;
    double smoothness = 0.5;  // 0 very rough, 1 very smooth
};

// A type that lies between two others wherever they meet (section VII.6).
struct Transition {
    std::string a, b, type;
    double width = 1000.0;  // metres
};

// A terrain library: kinds of land as people think of them.
struct LibraryOptions {
    std::string name;
    std::vector<TypeOptions> types;
    std::vector<Seam> seams = {};
    std::vector<Transition> transitions = {};
    // Levels of detail, metres from sample to sample, coarse to fine.
    std::vector<double> levels = {810.0, 270.0, 90.0, 30.0, 10.0};
};

// A closed polygon, in units of its map: east, north. It ends where it began.
using Outline = std::vector<std::array<double, 2>>;

// Land of one type (section IV.2.2): what is inside an odd number of outlines.
struct Region {
    std::string name;
    std::string type;
    std::vector<Outline> outlines;
};

struct MapOptions {
    std::vector<Region> regions;  // later ones lie over earlier ones
    // What lies under the terrain, in the map's units: west, south, east, north.
    std::array<double, 4> window{0.0, 0.0, 1.0, 1.0};
    bool refine = true;       // boundaries (section IV.3.1)
    double smoothness = 0.5;  // of boundaries that no seam of the library tells of
    // How far a refined boundary may be from the drawn one, metres; 0: a fifth of its
    // length.
    double envelope = 0.0;
    int automatic = 0;  // so many regions are made up (section VII.3); 0: as drawn
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

// What makes the finer levels.
enum class Optimiser {
    kTexture,    // parallel texture synthesis, from the genes of the second level on
    kEvolution,  // the genetic algorithm on every level
};

// Land by its kinds: Saunders, "Terrainosaurus: Realistic Terrain Synthesis Using Genetic
// Algorithms", 2006.
struct Options {
    LibraryOptions library;
    MapOptions map;
    int ratio = 3;            // of spacings, from level to level; 2 or 3
    double coarsest = 810.0;  // metres from sample to sample, at most
    Optimiser optimiser = Optimiser::kTexture;
    EvolutionOptions evolution;
    std::vector<texture::Point> points;  // placed features (section VII.2)
    std::vector<texture::Curve> curves;
};

}  // namespace cydonia::genetic
