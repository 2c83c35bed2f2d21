#pragma once

#include <vector>

#include "field/field.h"
#include "synth/detail/filters.h"

namespace cydonia::detail {

// What one level of reverse subdivision takes from a land (Brosz 2007, section 5): from
// its columns first, then from the rows of what is left.
struct Details {
    Field<float> columns;  // as wide as the fine land
    Field<float> rows;     // as high as the coarse one
};

struct Level {
    Details details;
    Field<float> coarse;  // what is left
};

// The finest level first. For sides that so many levels divide (divisible()).
std::vector<Level> decomposed(Field<float> land, Filter filter, int levels);

// One level up: rows, then columns.
Field<float> subdivided(const Field<float>& coarse, const Details& details,
                        Filter filter);

// Details that are nought, of a level whose coarse land is so large.
Details no_details(Filter filter, int coarse_width, int coarse_height);

// A land mirrored at its east and south ends to a size.
Field<float> padded(const Field<float>& land, int width, int height);

}  // namespace cydonia::detail
