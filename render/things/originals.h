#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "field/image.h"
#include "render/things/options.h"

namespace cydonia::render {

// What a thing is a copy of: triangles one metre high over the origin, z up, in two
// materials (wood and leaf, or stone alone), linear Rec.709 albedo.
struct Original {
    struct Part {
        Rgb albedo;
        bool smooth = false;  // shaded as if round
        std::vector<std::array<float, 3>> vertices;
        std::vector<std::array<std::uint32_t, 3>> triangles;
    };
    std::vector<Part> parts;
};

// The normals of a part's corners, by the faces around them.
std::vector<std::array<float, 3>> normals_of(const Original::Part& part);

// So many different ones of each kind.
inline constexpr int kOriginals = 4;
Original original_of(ThingOptions::Kind kind, int number);

// What a kind is where a scene says nothing else.
struct Habit {
    double density;               // a hectare
    std::array<double, 2> size;   // metres
    std::array<double, 2> slope;  // radians
    double sunk;                  // share of its height below the ground
};
const Habit& habit_of(ThingOptions::Kind kind);

}  // namespace cydonia::render
