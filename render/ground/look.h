#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/image.h"
#include "field/length.h"
#include "field/vec.h"

namespace cydonia::render {

// A height in a look: metres, or a share of the relief from the lowest ground to the
// highest, so that one look suits hills and mountains.
struct Elevation {
    double value = 0.0;
    bool of_relief = false;

    double in(double lowest, double relief) const {
        return of_relief ? lowest + value * relief : value;
    }
    bool operator==(const Elevation&) const = default;
};

// Beds of rock by height; each has one of the colours.
struct Strata {
    std::vector<Rgb> colours;  // linear Rec.709; empty: shades of the material itself
    double thickness = 40.0;   // metres, of the thicker beds
    double strength = 1.0;     // 0 to 1
    std::array<double, 2> slope{radians(15.0),
                                radians(32.0)};  // slopes over which they begin to show
};

// A material of the ground (config/materials/). Colours are linear Rec.709 albedos.
struct Material {
    std::string name;
    Rgb light{0.26f, 0.24f, 0.21f},
        dark{0.20f, 0.18f, 0.15f};  // its colour varies between these
    std::optional<Rgb> tint;        // a colour in patches: rust, lichen, flowers
    double tinted = 0.3;            // the share of the material that is tinted, 0 to 1
    double variation = 200.0;       // metres, of its patches
    double grain = 0.25;            // strength of noise of 20 m, 0 to 1
    double bump = 0.12;             // POV-Ray's bump amount, close up; 0: smooth
    double bump_size = 60.0;        // metres
    std::optional<Strata> strata;
};

// A condition that is not fulfilled at the value `none` and fulfilled at `full`, which
// may be the smaller of the two.
struct Ramp {
    double none = 0.0, full = 1.0;
    // Below 0 outside, above 1 well inside.
    double at(double value) const { return (value - none) / (full - none); }
};

// Where a material lies: all conditions must be fulfilled. Noise of two sizes moves the
// border between the two values of a condition, so that no contour line shows.
struct Layer {
    enum class Role { kNone, kRock, kScree, kSnow };

    std::size_t material = 0;  // index into the look's materials
    Role role = Role::kNone;   // which layer a scene's snow_line and rock_slope change
    std::optional<std::array<Elevation, 2>> above, below;
    std::optional<Ramp> slope;   // radians, measured over about 15 and 45 m
    std::optional<Ramp> gentle;  // a second condition of the slope, usually falling
    std::optional<Ramp> hollow;  // metres below the mean of the land within about 120 m
    std::optional<Ramp> wet;     // topographic wetness (render/ground/relief.h)
    std::optional<Ramp> north;   // how far it faces north: -1 to 1, 0 where level
    std::string
        mask;  // a mask of the terrain, 0 to 1; the layer lies nowhere if there is none
    double patches =
        1.0;  // the share that it covers, in patches, where the conditions hold
    double patch_size = 250.0;  // metres
    double north_lowers = 0.0;  // metres by which `above` is lower on steep north faces
    double hollow_lowers =
        0.0;            // metres by which `above` is lower for each metre of hollow
    double soft = 0.5;  // width of an edge, as a share of the way between the two values
    double amount = 1.0;  // opacity over what lies below it

    bool limited() const {
        return above || below || slope || gentle || hollow || wet || north ||
               !mask.empty() || patches < 1.0;
    }
};

// Which materials lie where (config/looks/). Each layer covers those before it.
struct Look {
    std::string name;
    std::vector<Material> materials{Material{}};
    std::vector<Layer> layers{Layer{}};
    std::optional<std::size_t> shore, bed;  // materials beside and under water
};

}  // namespace cydonia::render
