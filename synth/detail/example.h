#pragma once

#include <vector>

#include "field/progress.h"
#include "synth/detail/multiresolution.h"

namespace cydonia::detail {

// A target at the land's spacing, taken apart.
struct Example {
    int target = 0;             // its place in Options::targets
    int first = 0;              // the finest of the land's levels that it has details for
    std::vector<Level> levels;  // from there on, the finest first
    // Of each level's coarse cells 1 where heights are not known; may be empty.
    std::vector<Field<std::uint8_t>> unknown;

    // Null where it has no details for a level of the land.
    const Level* level(int of_land) const {
        const auto index = static_cast<std::size_t>(of_land - first);
        return of_land < first || index >= levels.size() ? nullptr : &levels[index];
    }
};

// All targets, each resampled to `spacing` metres or, where its own cells are larger, to
// the land's level that is nearest to them; in every orientation asked for. Says what was
// resampled. Throws bad_request: a target too coarse or too small for any detail.
std::vector<Example> examples_of(const Options& options, double spacing,
                                 Progress& progress);

// Land taken apart. Voids: 1 where heights are not known; may be empty. What is over the
// size that the filter divides is cut.
Example example_of(const Field<float>& heights, const Field<std::uint8_t>& voids,
                   Filter filter, int levels);

// The land turned by quarter turns and then, from 4 on, mirrored.
template <class T>
Field<T> oriented(const Field<T>& land, int orientation) {
    const int turns = orientation % 4;
    const bool across = turns % 2 == 1, mirrored = orientation >= 4;
    const int w = land.width(), h = land.height();
    Field<T> result(across ? h : w, across ? w : h);
    for (int y = 0; y < result.height(); ++y)
        for (int x = 0; x < result.width(); ++x) {
            const int i = mirrored ? result.width() - 1 - x : x;
            result(x, y) = turns == 0   ? land(i, y)
                           : turns == 1 ? land(y, h - 1 - i)
                           : turns == 2 ? land(w - 1 - i, h - 1 - y)
                                        : land(w - 1 - y, i);
        }
    return result;
}

}  // namespace cydonia::detail
