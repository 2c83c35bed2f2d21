#pragma once

#include <array>
#include <optional>

#include "field/quantise.h"
#include "field/rgb.h"
#include "field/terrain.h"

namespace cydonia::render {

// The look of water for all renderers. Colours are linear Rec.709.
inline constexpr double kWaterIndex = 1.33;  // of refraction
// Seas and lakes mix this colour with that of their bed, which keeps the share
// kWaterClear.
inline constexpr Rgb kWaterVeil{0.02f, 0.08f, 0.11f};
inline constexpr double kWaterClear = 0.8;
// The colour of a flood (WaterOptions), which hides its bed.
inline constexpr Rgb kFloodColour{0.004f, 0.016f, 0.022f};
// The colour and opacity of water for viewers without reflections of the sky (glTF).
inline constexpr std::array<double, 4> kPlainWater{0.02, 0.06, 0.08, 0.85};

// The surface of seas and lakes as a height field on the land's grid. A wet sample has
// the level of its water. A dry sample beside it has the same level or, where the land is
// lower, a height just under the land, so that the two meshes intersect at the shore
// only. All other samples have the 16-bit level 0 and no surface.
struct WaterSurface {
    Heights16 heights;
    // The level of the sea, which continues outside the land, metres: the lowest water
    // that reaches the land's border, if any does.
    std::optional<double> sea;
};

// Nothing when no sample is wet.
std::optional<WaterSurface> water_surface(const Terrain& terrain);

}  // namespace cydonia::render
