#pragma once

#include <cstdint>
#include <functional>

#include "field/progress.h"
#include "field/terrain.h"

namespace cydonia {

// What a stage may use besides its options and the terrain so far; owned by app/.
struct Context {
    std::uint64_t seed =
        0;  // of this stage: a hash of the scene's seed and the stage's place
    // Hard shadows of the terrain under the sun, as the Embree caster sees them: `rays` x
    // `rays` samples a cell, so (rays * width) x (rays * height), 1 in shadow.
    std::function<Field<std::uint8_t>(const Terrain&, const Sun&, int rays)> cast;
    Progress* progress = nullptr;  // never null when a stage runs
};

}  // namespace cydonia
