#pragma once

#include <vector>

#include "field/progress.h"
#include "synth/detail/multiresolution.h"

namespace cydonia::detail {

// A target at the land's spacing, decomposed into levels of detail.
struct Example {
    int target = 0;             // its place in Options::targets
    int first = 0;              // finest of the land's levels for which it has details
    std::vector<Level> levels;  // from `first` on, the finest first
    // For each level 1 at coarse cells whose height is not known; may be empty.
    std::vector<Field<std::uint8_t>> unknown;

    // Details for a level of the land, or null.
    const Level* level(int of_land) const {
        const auto index = static_cast<std::size_t>(of_land - first);
        return of_land < first || index >= levels.size() ? nullptr : &levels[index];
    }
};

// All targets, in every requested orientation. Each is resampled to `spacing` metres or,
// if its own cells are larger, to the spacing of the nearest of the land's levels. Says
// what was resampled. Throws bad_request for a target too coarse or too small for any
// detail.
std::vector<Example> examples_of(const Options& options, double spacing,
                                 Progress& progress);

// The decomposition of a land. `voids` is 1 where heights are not known; may be empty.
// The land is cropped to a size that the filter can halve.
Example example_of(const Field<float>& heights, const Field<std::uint8_t>& voids,
                   Filter filter, int levels);

// The land after (orientation % 4) quarter turns, and mirrored from 4 on.
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
