#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "field/source.h"
#include "synth/geometry/options.h"

namespace cydonia::genetic {

// Real land of one type. `window` is the part of the model that is used: its west, south,
// east and north side as shares from the model's south-west corner.
struct Example {
    Source source;
    std::array<double, 4> window{0.0, 0.0, 1.0, 1.0};
    // The land is stretched horizontally by `scale` and vertically by `vertical_scale`,
    // then raised by `raise` metres.
    double scale = 1.0, vertical_scale = 1.0, raise = 0.0;
};

// A type of land, described by examples (Saunders 2006, section IV.2.1).
struct TypeOptions {
    std::string name;
    std::vector<Example> examples;
    std::array<std::uint8_t, 3> colour{};  // in pictures and maps
};

// How boundaries between types `a` and `b` are refined (section V.3.3.4).
struct Seam {
    std::string a, b;
    double smoothness = 0.5;  // 0 very rough, 1 very smooth
};

// A type that is put between types `a` and `b` wherever they meet (section VII.6).
struct Transition {
    std::string a, b, type;
    double width = 1000.0;  // metres
};

// A terrain library: types of land as people think of them.
struct LibraryOptions {
    std::string name;
    std::vector<TypeOptions> types;
    std::vector<Seam> seams = {};
    std::vector<Transition> transitions = {};
    // Levels of detail, coarse to fine: metres from sample to sample.
    std::vector<double> levels = {810.0, 270.0, 90.0, 30.0, 10.0};
};

// A closed polygon of positions east and north in the map's units. The first point is
// repeated at the end.
using Outline = std::vector<std::array<double, 2>>;

// Land of one type (section IV.2.2): everything inside an odd number of its outlines.
struct MapRegion {
    std::string name;
    std::string type;
    std::vector<Outline> outlines;
};

struct MapOptions {
    std::vector<MapRegion> regions;  // later ones lie over earlier ones
    // The part of the map under the terrain: its west, south, east and north side in the
    // map's units.
    std::array<double, 4> window{0.0, 0.0, 1.0, 1.0};
    bool refine = true;       // refine boundaries (section IV.3.1)
    double smoothness = 0.5;  // of boundaries without a seam in the library
    // How far a refined boundary may stray from the drawn one, metres; 0: a fifth of its
    // length.
    double envelope = 0.0;
    int automatic = 0;  // number of made-up regions (section VII.3); 0: as drawn
};

// Parameters of the height field genetic algorithm (section IV.3.3). For the defaults see
// docs/papers.md, Saunders 2006, 2, and bench/evolution.cpp.
struct EvolutionOptions {
    int gene = 16;         // side, cells
    double overlap = 0.3;  // share of a gene's side
    int population = 15, cycles = 15;
    double mutation = 0.5;                   // P_m of eq. IV.15
    double elitism = 0.2, selection = 0.75;  // shares of the population
    double alpha = 0.5;                      // of eq. IV.13
    int crossed = 8;  // genes across, at most, that a crossover copies
};

// The method that makes the finer levels.
enum class Optimiser {
    kTexture,    // parallel texture synthesis, from the genes of the second level on
    kEvolution,  // the genetic algorithm on every level
};

// Land by its types: Saunders, "Terrainosaurus: Realistic Terrain Synthesis Using Genetic
// Algorithms", 2006.
struct Options {
    LibraryOptions library;
    MapOptions map;
    int ratio = 3;            // of the spacings of successive levels; 2 or 3
    double coarsest = 810.0;  // largest spacing of a level, metres
    Optimiser optimiser = Optimiser::kTexture;
    EvolutionOptions evolution;
    std::vector<geometry::Point> points;  // placed features (section VII.2)
    std::vector<geometry::Curve> curves;
};

}  // namespace cydonia::genetic
