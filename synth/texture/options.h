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

// A real elevation model, from which land is made.
struct Exemplar {
    Source source;
    // A picture in the types' colours, stretched over the model.
    std::optional<Source> types;
    std::string type;  // of the whole model, instead of a picture; empty: none
    // The part of the model that is used: its west, south, east and north side as shares
    // from the model's south-west corner.
    std::array<double, 4> window{0.0, 0.0, 1.0, 1.0};
    // Factors on top of those in Options, and metres added to the heights.
    double scale = 1.0, vertical_scale = 1.0, raise = 0.0;
};

// T of section 5.2, a kind of land, and the colour that stands for it in pictures.
struct Type {
    std::string name;
    std::array<std::uint8_t, 3> colour{};
};

// A region copied from an exemplar, or from this terrain as it is without pastes, and
// locked where it is put (section 5.3).
struct Paste {
    std::string name;
    int exemplar = 0;  // its number in the list, from 1; 0: from this terrain
    std::array<double, 2> from{0.5, 0.5};  // centre, as shares of the exemplar
    geometry::Place2 to{of_width(0.5), of_width(0.5)};  // where that centre is put
    // The shape of the region around `from`: a disc with this radius, or a polygon in
    // metres east and north of it. With neither it is the whole exemplar.
    Length radius = {};
    std::vector<std::array<double, 2>> outline = {};
    double raise = 0.0;   // metres added to its heights
    int turn = 0;         // quarter turns clockwise; of an exemplar only
    bool mirror = false;  // swaps east and west before the turn
};

// Parallel synthesis from real land: Gain, Merry and Marais, "Parallel, Realistic and
// Controllable Terrain Synthesis", 2015.
struct Options {
    std::vector<Exemplar> exemplars;

    // Metres from one cell of the synthesis to the next; 0: as in the first exemplar.
    // Exemplars of other spacing are resampled.
    double spacing = 0.0;
    double scale = 1.0;           // stretches exemplars horizontally
    double vertical_scale = 1.0;  // factor of their heights
    int levels = 6;               // L
    int orientations = 1;         // 1, 2, 4 or 8: turned and mirrored matches
    double jitter = 0.2;          // r of eq. 1; the paper has 0.4 (bench/realism.sh)
    double kappa = 2.0;           // of eq. 7, for j = 2

    std::vector<Type> types;
    bool automatic_types = false;  // sorts exemplars into `types`, calmest first
    std::optional<Source> paint;   // types painted on the terrain

    std::vector<geometry::Point> points;
    std::vector<geometry::Curve> curves;
    double stiffness = 0.5;  // s of eq. 8, metres of height over metres of distance
    double pull = 0.5;       // lambda of eq. 8

    std::vector<Paste> pastes;
    bool coherent = false;         // keeps the last run's land where nothing changed
    std::optional<Source> frozen;  // white: keeps exactly the last run's land

    bool breach = false;  // cuts a way out for channels that end nowhere
};

}  // namespace cydonia::texture
