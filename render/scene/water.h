#pragma once

#include <array>
#include <optional>

#include "field/quantise.h"
#include "field/rgb.h"
#include "field/terrain.h"

namespace cydonia::render {

// How water looks to whoever draws it. Colours are linear Rec.709.
inline constexpr double kWaterIndex = 1.33;  // of refraction
// Seas and lakes lay this over their bed, which shows through by this share.
inline constexpr Rgb kWaterVeil{0.02f, 0.08f, 0.11f};
inline constexpr double kWaterClear = 0.8;
// A flood, the water below one level, hides its bed.
inline constexpr Rgb kFloodColour{0.004f, 0.016f, 0.022f};
// For viewers that mirror no sky: its colour, and how opaque it is.
inline constexpr std::array<double, 4> kPlainWater{0.02, 0.06, 0.08, 0.85};

// The surface of seas and lakes as a height field on the land's grid. At a wet sample it
// is at its level. Beside one it is at the same level or, where the land is lower, just
// under the land, so that the two meshes meet at the shore and nowhere else. Elsewhere
// there is none: level 0, all others are above.
struct WaterSurface {
    Heights16 heights;
    // Of the lowest water that reaches the border of the land, metres, if any does: the
    // sea, which goes on outside.
    std::optional<double> sea;
};

// Nothing where no sample is wet.
std::optional<WaterSurface> water_surface(const Terrain& terrain);

}  // namespace cydonia::render
