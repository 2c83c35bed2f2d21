#pragma once

#include <array>
#include <cstdint>

#include "synth/texture/database/database.h"
#include "synth/texture/database/orientation.h"
#include "synth/texture/database/pyramid.h"

namespace cydonia::texture {

// How heights are stored in appearance space: (height - datum) / unit.
struct HeightScale {
    double datum = 0.0;  // metres
    double unit = 1.0;   // metres
};

// The weights of a 5x5 neighbourhood that make A^i from E^i, row by row from its
// north-west cell. They are integers, so that sums are the same in any order and a turned
// neighbourhood has exactly the turned modes.
struct Modes {
    using Weights = std::array<std::int32_t, 25>;  // parts of kOne
    static constexpr int kOne = 1 << 14;
    std::array<Weights, 4> weights{};
    std::array<std::int8_t, 8> last_sign{};
};

// The mean, and the principal components of the level's neighbourhoods without their
// mean. Components are restricted to patterns that turns and mirrorings map to one
// another.
Modes modes_of(const LevelArrays& level);

// Fills `appearance`, including guards, and `last_sign`. Heights must be within 30,000
// units of the datum.
void add_appearance(LevelArrays& level, const Modes& modes, const HeightScale& scale);

// The appearance of an exemplar's cell as the terrain sees it when the exemplar is laid
// down with `orientation`: the slope along a step on the terrain is that along the
// exemplar's step.
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
