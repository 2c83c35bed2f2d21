#pragma once

#include <algorithm>
#include <cstdint>

#include "synth/texture/database/database.h"
#include "synth/texture/database/orientation.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// An Origin unpacked: a position in half cells of level 0, of which a cell of level i is
// 2^(i+1) wide. Unlike an Origin it may lie outside its exemplar.
struct Spot {
    int exemplar = 0, orientation = 0;
    int x = 0, y = 0;

    Spot moved(Step half_cells) const {
        return {exemplar, orientation, x + half_cells.x, y + half_cells.y};
    }
    bool operator==(const Spot&) const = default;
};

inline Spot spot_of(const Origin& place) {
    constexpr std::uint32_t kCoordinate = (1u << 21) - 1;
    return {place.exemplar(), place.orientation(), int(place.x & kCoordinate),
            int(place.y)};
}

inline Origin origin_of(const Spot& spot) {
    return {std::uint32_t(spot.exemplar) << 24 | std::uint32_t(spot.orientation) << 21 |
                std::uint32_t(spot.x),
            std::uint32_t(spot.y)};
}

// The coordinate of the centre of its cell.
inline int snapped(int half_cells, int level) {
    return (half_cells >> (level + 1) << (level + 1)) + (1 << level);
}

// The nearest position on the sheet, so that every stored origin lies on its exemplar.
inline Spot kept_inside(Spot spot, const Sheet& sheet, int level) {
    spot.x = std::clamp(spot.x, 0, (sheet.width << (level + 1)) - 1);
    spot.y = std::clamp(spot.y, 0, (sheet.height << (level + 1)) - 1);
    return spot;
}

// Converts steps on the terrain to steps on the exemplar, for each orientation.
struct Turns {
    Step east[8], south[8];
    std::uint8_t composed[8][8];

    constexpr Turns() : east{}, south{}, composed{} {
        for (int o = 0; o < 8; ++o) {
            east[o] = turned(o, {1, 0});
            south[o] = turned(o, {0, 1});
            for (int p = 0; p < 8; ++p)
                composed[o][p] = std::uint8_t(texture::composed(o, p));
        }
    }
    Step operator()(int orientation, int x, int y) const {
        const Step e = east[orientation], s = south[orientation];
        return {e.x * x + s.x * y, e.y * x + s.y * y};
    }
};
inline constexpr Turns kTurns;

}  // namespace cydonia::texture
