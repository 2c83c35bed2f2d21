#pragma once

#include "synth/texture/synthesis/origins.h"

namespace cydonia::texture {

// E at a position on an exemplar, metres; bilinear between cells.
inline float height_at(const Level& level, int index, const Spot& spot) {
    const Sheet& sheet = level.sheets[std::size_t(spot.exemplar)];
    const int bits = index + 1, half = 1 << index;
    const int x = spot.x - half, y = spot.y - half;
    const int mask = (1 << bits) - 1;
    const float* h = level.heights.data() + sheet.index(x >> bits, y >> bits);
    if (((x | y) & mask) == 0) return *h;
    const float u = float(x & mask) / float(1 << bits);
    const float v = float(y & mask) / float(1 << bits);
    const float upper = h[0] + u * (h[1] - h[0]);
    const float lower = h[sheet.stride] + u * (h[sheet.stride + 1] - h[sheet.stride]);
    return upper + v * (lower - upper);
}

}  // namespace cydonia::texture
