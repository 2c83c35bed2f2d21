#pragma once

#include <array>
#include <vector>

#include "synth/detail/options.h"

namespace cydonia::detail {

// A weighted sum of a few values of a line.
struct Stencil {
    struct Tap {
        int index = 0;
        float weight = 0.0f;
    };
    std::array<Tap, 7> taps;
    int count = 0;
};

// One level of the multiresolution analysis of a line (Samavati and Bartels 1999). It is
// exact: `fine` values correspond to `coarse` ones and `details`.
struct FilterBank {
    int fine = 0, coarse = 0, details = 0;
    std::vector<Stencil> a, b;  // coarse values and details from fine values (A, B)
    // Fine values from coarse ones, which come first, and details (P, Q).
    std::vector<Stencil> pq;
};
FilterBank filter_bank(Filter filter, int coarse);

// The shortest line of at least `length` values that can be halved `levels` times.
int divisible(Filter filter, int length, int levels);
// The length of a line on the next coarser level.
int coarser(Filter filter, int length);

}  // namespace cydonia::detail
