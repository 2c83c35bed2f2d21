#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/image.h"
#include "field/length.h"
#include "field/vec.h"

namespace cydonia::render {

// A height that a look names: metres, or a share of the way from the land's lowest ground
// to its highest, so that one look suits hills and mountains.
struct Elevation {
    double value = 0.0;
    bool of_relief = false;

    double in(double lowest, double relief) const {
        return of_relief ? lowest + value * relief : value;
    }
    bool operator==(const Elevation&) const = default;
};

// Beds of rock by height, each of one of the colours.
struct Strata {
    std::vector<Rgb> colours;  // linear Rec.709; empty: shades of the material itself
    double thickness = 40.0;   // metres, of the thicker beds
    double strength = 1.0;     // 0 to 1
    std::array<double, 2> slope{radians(15.0),
                                radians(32.0)};  // where they begin to show
};

// What ground is made of (config/materials/). Colours are linear Rec.709 albedos.
struct Material {
    std::string name;
    Rgb light{0.26f, 0.24f, 0.21f}, dark{0.20f, 0.18f, 0.15f};  // it varies between
    std::optional<Rgb> tint;   // here and there instead: rust, lichen, flowers
    double tinted = 0.3;       // the share of it that is, 0 to 1
    double variation = 200.0;  // metres, of its patches
    double grain = 0.25;       // what noise of 20 m adds to them, 0 to 1
    double bump = 0.12;        // POV-Ray's bump amount, close up; 0: smooth
    double bump_size = 60.0;   // metres
    std::optional<Strata> strata;
};

// From a value where nothing holds to one where all does; falling where full < none.
struct Ramp {
    double none = 0.0, full = 1.0;
    // Below 0 outside, above 1 well inside.
    double at(double value) const { return (value - none) / (full - none); }
};

// Where a material lies: all conditions must hold. Between the two values of a condition
// the border wanders, moved by noise of two sizes, so that no contour line shows.
struct Layer {
    enum class Role { kNone, kRock, kScree, kSnow };

    std::size_t material = 0;  // of the look's
    Role role = Role::kNone;   // what a scene's snow_line and rock_slope speak of
    std::optional<std::array<Elevation, 2>> above, below;
    std::optional<Ramp> slope;   // radians, at about 15 and 45 m
    std::optional<Ramp> gentle;  // the same, for a second limit: usually falling
    std::optional<Ramp> hollow;  // metres below the land around, at about 120 m
    std::optional<Ramp> wet;     // topographic wetness (render/ground/relief.h)
    std::optional<Ramp> north;   // how far it faces north: -1 to 1, 0 where level
    std::string mask;            // one of the terrain's, 0 to 1; nowhere without it
    double patches = 1.0;        // the share of the rest that it covers, in patches
    double patch_size = 250.0;   // metres
    double north_lowers = 0.0;   // metres that `above` lies lower on steep north faces
    double hollow_lowers = 0.0;  // metres a metre of hollow
    double soft = 0.5;           // of the way between the values that an edge takes
    double amount = 1.0;         // how much of what lies below it covers

    bool limited() const {
        return above || below || slope || gentle || hollow || wet || north ||
               !mask.empty() || patches < 1.0;
    }
};

// Which materials lie where (config/looks/). Layers cover those before them.
struct Look {
    std::string name;
    std::vector<Material> materials{Material{}};
    std::vector<Layer> layers{Layer{}};
    std::optional<std::size_t> shore, bed;  // materials beside and under water
};

}  // namespace cydonia::render
