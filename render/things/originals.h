#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "field/image.h"
#include "render/things/options.h"

namespace cydonia::render {

// The model that things are copies of: triangles, one metre high above the origin, z up.
// It has a part for each material (wood and leaf, or stone), with linear Rec.709 albedo.
struct Original {
    struct Part {
        Rgb albedo;
        bool smooth = false;  // shaded with interpolated normals
        std::vector<std::array<float, 3>> vertices;
        std::vector<std::array<std::uint32_t, 3>> triangles;
    };
    std::vector<Part> parts;
};

// The normals at a part's corners, from the faces around them.
std::vector<std::array<float, 3>> normals_of(const Original::Part& part);

// The number of different originals of each kind.
inline constexpr int kOriginals = 4;
Original original_of(ThingOptions::Kind kind, int number);

// The numbers of a kind that a scene does not set.
struct Habit {
    double density;               // things a hectare
    std::array<double, 2> size;   // metres
    std::array<double, 2> slope;  // radians
    double sunk;                  // share of its height that is below the ground
};
const Habit& habit_of(ThingOptions::Kind kind);

}  // namespace cydonia::render
