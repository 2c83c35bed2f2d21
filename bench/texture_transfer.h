#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia::bench {

// Heights in place of details: image quilting for texture transfer (Efros and Freeman
// 2001, section 3), which Brosz 2007, section 7.4, compares with: three iterations,
// blocks of 16 cells and a third less each time, overlapping by 17 %, 50 candidates.
// Land like `base`, of pieces of `example`, each raised to the base's mean height.
Field<float> texture_transferred(const Field<float>& base, const Field<float>& example,
                                 std::uint64_t seed);

}  // namespace cydonia::bench
