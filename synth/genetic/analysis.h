#pragma once

#include <array>
#include <string_view>

#include "field/terrain.h"
#include "synth/genetic/statistics.h"

namespace cydonia::genetic {

// The quantities whose distributions make up a kind of land (section IV.3.2).
enum class Quantity { kElevation, kSlope, kEdgeScale, kEdgeLength, kEdgeStrength };
inline constexpr int kQuantities = 5;
inline constexpr std::array<std::string_view, kQuantities> kQuantityNames = {
    "elevation", "slope", "edge scale", "edge length", "edge strength"};

// Of a land at one level of detail. Elevations, scales and lengths in metres, slopes in
// degrees.
using Analysis = std::array<Statistics, kQuantities>;

Analysis analysis_of(const Terrain& terrain);

// The land with so many metres from sample to sample, its mean where that is more.
Terrain at_level(const Terrain& terrain, double spacing);

inline constexpr int kAnalysisVersion = 1;  // raised when the same land gives other ones

}  // namespace cydonia::genetic
