#pragma once

#include <cstdint>
#include <cstring>

#include "synth/texture/synthesis/origins.h"

namespace cydonia::texture {

using Int4 = std::int32_t __attribute__((vector_size(16)));
using Float4 = float __attribute__((vector_size(16)));
using Short4 = std::int16_t __attribute__((vector_size(8)));

// Reads A^i at positions on the exemplars, as the terrain sees it in their orientation.
class AppearanceReader {
  public:
    AppearanceReader(const Level& level, int index) : level_(level), index_(index) {
        for (int o = 0; o < 8; ++o) {
            // The slope along a step on the terrain is that along the exemplar's step.
            const Step e = kTurns.east[o], s = kTurns.south[o];
            swapped_[o] = e.x == 0;
            sign_[o] = Int4{1, e.x + e.y, s.x + s.y, level.last_sign[std::size_t(o)]};
        }
    }

    // A position around which neighbours are read. For snapped positions it holds
    // everything that does not depend on the neighbour.
    struct Around {
        Spot spot;
        const Appearance* cell = nullptr;
        std::ptrdiff_t east = 0, south = 0;  // index steps to the terrain's neighbours
    };
    template <bool kSnapped>
    Around around(const Spot& spot) const {
        if constexpr (!kSnapped) return {spot};
        const Sheet& sheet = level_.sheets[std::size_t(spot.exemplar)];
        const Step e = kTurns.east[spot.orientation], s = kTurns.south[spot.orientation];
        return {
            spot,
            &level_
                 .appearance[sheet.index(spot.x >> (index_ + 1), spot.y >> (index_ + 1))],
            std::ptrdiff_t(e.y) * sheet.stride + e.x,
            std::ptrdiff_t(s.y) * sheet.stride + s.x};
    }

    // The appearance x cells to the east and y to the south of it on the terrain.
    template <bool kSnapped>
    Int4 at(const Around& place, int x, int y) const {
        const int o = place.spot.orientation;
        Int4 a;
        if constexpr (kSnapped) {
            a = whole(place.cell + x * place.east + y * place.south);
        } else {
            const Spot there =
                place.spot.moved(kTurns(o, x << (index_ + 1), y << (index_ + 1)));
            a = between(level_.sheets[std::size_t(there.exemplar)], there);
        }
        return o == 0 ? a : laid_down(a, o);
    }

    // Prefetches what will be read around a position.
    void fetch(const Around& place) const {
        if (!place.cell) return;
        __builtin_prefetch(place.cell - place.south);
        __builtin_prefetch(place.cell + place.south);
    }

  private:
    static Int4 whole(const Appearance* cell) {
        Short4 a;
        std::memcpy(&a, cell, sizeof a);
        return __builtin_convertvector(a, Int4);
    }
    Int4 cell(std::size_t index) const { return whole(&level_.appearance[index]); }
    // Bilinear interpolation with weights in 64ths each way.
    Int4 between(const Sheet& sheet, const Spot& spot) const {
        const int x = spot.x - (1 << index_), y = spot.y - (1 << index_);
        const int bits = index_ + 1;
        const int u = part(x, bits), v = part(y, bits);
        const std::size_t i = sheet.index(x >> bits, y >> bits);
        const std::size_t below = i + std::size_t(sheet.stride);
        const Int4 upper = cell(i) * (64 - u) + cell(i + 1) * u;
        const Int4 lower = cell(below) * (64 - u) + cell(below + 1) * u;
        return (upper * (64 - v) + lower * v + 2048) >> 12;
    }
    static int part(int half_cells, int bits) {
        const int within = half_cells & ((1 << bits) - 1);
        return bits >= 6 ? within >> (bits - 6) : within << (6 - bits);
    }
    Int4 laid_down(Int4 a, int orientation) const {
        if (swapped_[orientation]) a = __builtin_shuffle(a, Int4{0, 2, 1, 3});
        return a * sign_[orientation];
    }

    const Level& level_;
    int index_;
    bool swapped_[8];
    Int4 sign_[8];
};

}  // namespace cydonia::texture
