#pragma once

#include <algorithm>

#include "field/field.h"
#include "field/parallel.h"

namespace cydonia::pareidolia {

// Sets out(y, x) = in(x, y), in tiles that fit the nearest cache in both directions.
inline Field<float> transposed(const Field<float>& in) {
    constexpr int kTile = 32;
    Field<float> out(in.height(), in.width());
    parallel_for((in.height() + kTile - 1) / kTile, [&](int band) {
        const int past = std::min(in.height(), (band + 1) * kTile);
        for (int x0 = 0; x0 < in.width(); x0 += kTile)
            for (int y = band * kTile; y < past; ++y)
                for (int x = x0; x < std::min(in.width(), x0 + kTile); ++x)
                    out(y, x) = in(x, y);
    });
    return out;
}

}  // namespace cydonia::pareidolia
