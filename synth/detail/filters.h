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

// One level of a line's multiresolution analysis (Samavati and Bartels 1999): `fine`
// values are `coarse` ones and `details`, exactly.
struct FilterBank {
    int fine = 0, coarse = 0, details = 0;
    std::vector<Stencil> a, b;  // coarse values and details, of fine ones (A, B)
    // Fine values (P, Q), of coarse ones, which come first, and details.
    std::vector<Stencil> pq;
};
FilterBank filter_bank(Filter filter, int coarse);

// The shortest line of at least `length` values that `levels` levels divide.
int divisible(Filter filter, int length, int levels);
// Of a line so long: of the next coarser level.
int coarser(Filter filter, int length);

}  // namespace cydonia::detail
