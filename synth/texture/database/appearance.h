#pragma once

#include <array>
#include <cstdint>

#include "synth/texture/database/database.h"
#include "synth/texture/database/orientation.h"
#include "synth/texture/database/pyramid.h"

namespace cydonia::texture {

// Heights as appearance stores them.
struct HeightScale {
    double datum = 0.0;  // metres
    double unit = 1.0;   // metres
};

// What makes A^i of E^i: weights of a 5x5 neighbourhood, row by row from its north-west
// cell. Whole numbers, so that sums are the same in any order and a turned neighbourhood
// has exactly the turned modes.
struct Modes {
    using Weights = std::array<std::int32_t, 25>;  // parts of kOne
    static constexpr int kOne = 1 << 14;
    std::array<Weights, 4> weights{};
    std::array<std::int8_t, 8> last_sign{};
};

// The mean, and the principal components of what is left of the level's neighbourhoods
// without it, among those that turn and mirror into one another.
Modes modes_of(const LevelArrays& level);

// Fills appearance, guards too, and last_sign. Needs heights within 30,000 units of the
// datum.
void add_appearance(LevelArrays& level, const Modes& modes, const HeightScale& scale);

// How a cell of an exemplar that is laid down with `orientation` looks to the terrain:
// the slope along a step of the terrain is that along the exemplar's step.
inline Appearance turned_appearance(const Appearance& a, int orientation,
                                    const std::array<std::int8_t, 8>& last_sign) {
    const Step east = turned(orientation, {1, 0}), south = turned(orientation, {0, 1});
    const auto along = [&](Step step) {
        return static_cast<std::int16_t>(step.x * a[1] + step.y * a[2]);
    };
    return {a[0], along(east), along(south),
            static_cast<std::int16_t>(last_sign[std::size_t(orientation)] * a[3])};
}

}  // namespace cydonia::texture
