#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>

#include "synth/texture/database/kd_tree.h"
#include "synth/texture/database/orientation.h"
#include "synth/texture/database/pyramid.h"

namespace cydonia::texture {

using Float4 = float __attribute__((vector_size(16)));

// The cells of a neighbourhood that are compared: those that correction compares (eq. 4)
// and the middle one, each of which describes the 5x5 cells around it. More cells, or
// cells farther apart, made the synthesis repeat itself a little more.
inline constexpr std::array<Step, 5> kCompared = {
    {{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
inline constexpr float kComparedCells = kCompared.size();

// The appearance of those cells, with heights relative to the middle one.
using View = std::array<Float4, kCompared.size()>;

inline Float4 floats_of(const Appearance& a) {
    using Short4 = std::int16_t __attribute__((vector_size(8)));
    Short4 shorts;
    std::memcpy(&shorts, a.data(), sizeof shorts);
    return __builtin_convertvector(shorts, Float4);
}

// The view that an exemplar laid down with `orientation` must have to be like this cell.
View wanted_view(const LevelArrays& level, int exemplar, int x, int y, int orientation);

// The mean squared difference between two neighbourhoods when the second is raised or
// lowered to fit best. In squared units of appearance space.
inline float dissimilarity(const View& wanted, const Appearance* at, int stride) {
    const Float4 height = {float((*at)[0]), 0, 0, 0};
    Float4 squares{}, sum{};
    for (std::size_t k = 0; k < kCompared.size(); ++k) {
        const Appearance& other = at[kCompared[k].y * stride + kCompared[k].x];
        const Float4 difference = wanted[k] - (floats_of(other) - height);
        squares += difference * difference;
        sum += difference;
    }
    // The best offset is the mean difference of heights.
    const float all = squares[0] + squares[1] + squares[2] + squares[3];
    return (all - sum[0] * sum[0] / kComparedCells) / kComparedCells;
}

// The directions in which the neighbourhoods of a level differ most, with heights
// relative to their mean.
class TraitSpace {
  public:
    explicit TraitSpace(const LevelArrays& level);
    Traits traits_of(const View& view) const;

  private:
    Float4 axes_[kCompared.size()][4][kTraits / 4];
};

}  // namespace cydonia::texture
