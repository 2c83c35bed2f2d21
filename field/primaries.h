#pragma once

#include <array>

#include "field/image.h"

namespace cydonia {

// The one conversion between linear Rec.709, in which POV-Ray computes, and ACEScg, in
// which scenes and deliveries are. White stays white: Rec.709 to XYZ, Bradford from D65
// to the ACES white, XYZ to AP1 (S-2014-004).
using PrimariesMatrix = std::array<Rgb, 3>;
inline constexpr PrimariesMatrix kAcesCgFromRec709{
    {{0.6130974f, 0.3395231f, 0.0473795f},
     {0.0701937f, 0.9163539f, 0.0134524f},
     {0.0206156f, 0.1095698f, 0.8698146f}}};
inline constexpr PrimariesMatrix kRec709FromAcesCg{
    {{1.7050510f, -0.6217921f, -0.0832589f},
     {-0.1302564f, 1.1408047f, -0.0105483f},
     {-0.0240034f, -0.1289690f, 1.1529725f}}};

constexpr Rgb converted(const PrimariesMatrix& m, const Rgb& c) {
    Rgb result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = m[i][0] * c[0] + m[i][1] * c[1] + m[i][2] * c[2];
    return result;
}
constexpr Rgb acescg_from_rec709(const Rgb& rec709) {
    return converted(kAcesCgFromRec709, rec709);
}
constexpr Rgb rec709_from_acescg(const Rgb& acescg) {
    return converted(kRec709FromAcesCg, acescg);
}

}  // namespace cydonia
