#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "field/length.h"
#include "field/source.h"
#include "synth/geometry/options.h"

namespace cydonia::texture {

// A real elevation model that land is made of.
struct Exemplar {
    Source source;
    // Painted types: a picture in the types' colours, stretched over the model.
    std::optional<Source> types;
    std::string type;  // of the whole model instead; empty: none
    // The part of it that is used: shares from its south-west corner, west, south, east
    // and north.
    std::array<double, 4> window{0.0, 0.0, 1.0, 1.0};
    // Besides Options' own, and metres that it lies higher.
    double scale = 1.0, vertical_scale = 1.0, raise = 0.0;
};

// T, section 5.2: a kind of land, by the colour that stands for it in pictures.
struct Type {
    std::string name;
    std::array<std::uint8_t, 3> colour{};
};

// Section 5.3: a region taken from an exemplar or from this terrain as it is without
// pastes, and locked where it is put.
struct Paste {
    std::string name;
    int exemplar = 0;  // its number in the list, from 1; 0: from this terrain
    std::array<double, 2> from{0.5, 0.5};  // centre, as shares of where it is taken from
    Place2 to{of_width(0.5), of_width(0.5)};  // where that centre comes to lie
    // The region around `from`: a disc, or a polygon (metres east and north of it). With
    // neither the whole exemplar.
    Length radius = {};
    std::vector<std::array<double, 2>> outline = {};
    double raise = 0.0;   // metres added to its heights
    int turn = 0;         // quarter turns clockwise, of an exemplar's region
    bool mirror = false;  // east for west before it is turned
};

// Parallel synthesis from real land: Gain, Merry and Marais, "Parallel, Realistic and
// Controllable Terrain Synthesis", 2015.
struct Options {
    std::vector<Exemplar> exemplars;

    // Metres from a cell of the synthesis to the next; 0: as in the first exemplar.
    // Exemplars of other spacing are resampled.
    double spacing = 0.0;
    double scale = 1.0;           // exemplars are stretched sideways by this
    double vertical_scale = 1.0;  // and their heights
    int levels = 6;               // L
    int orientations = 1;         // 1, 2, 4 or 8: turned and mirrored matches
    double jitter = 0.2;          // r of eq. 1; the paper has 0.4 (bench/realism.sh)
    double kappa = 2.0;           // of eq. 7, for j = 2

    std::vector<Type> types;
    bool automatic_types = false;  // exemplars sorted into `types`, from calm to rugged
    std::optional<Source> paint;   // types painted on the terrain

    std::vector<Point> points;
    std::vector<Curve> curves;
    double stiffness = 0.5;  // s of eq. 8, metres of height over metres of distance
    double pull = 0.5;       // lambda of eq. 8

    std::vector<Paste> pastes;
    bool coherent = false;         // keep to the last run's result where nothing changed
    std::optional<Source> frozen;  // white: exactly the last run's result

    bool breach = false;  // channels that end nowhere are cut through
};

}  // namespace cydonia::texture
