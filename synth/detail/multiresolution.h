#pragma once

#include <vector>

#include "field/field.h"
#include "synth/detail/filters.h"

namespace cydonia::detail {

// The details that one level of reverse subdivision takes from a land (Brosz 2007,
// section 5), first from its columns, then from the rows of the remaining land.
struct Details {
    Field<float> columns;  // as wide as the fine land
    Field<float> rows;     // as high as the coarse one
};

struct Level {
    Details details;
    Field<float> coarse;  // the remaining land
};

// The levels of a land, the finest first. Its sides must be divisible().
std::vector<Level> decomposed(Field<float> land, Filter filter, int levels);

// The land one level finer: subdivides rows, then columns.
Field<float> subdivided(const Field<float>& coarse, const Details& details,
                        Filter filter);

// Details that are all 0, for a level with a coarse land of this size.
Details no_details(Filter filter, int coarse_width, int coarse_height);

// A land extended to a size by reflection at its east and south ends.
Field<float> padded(const Field<float>& land, int width, int height);

}  // namespace cydonia::detail
