#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "field/terrain.h"
#include "synth/statistics/statistics.h"

namespace cydonia::genetic {

// The quantities whose distributions make up a kind of land (section IV.3.2, and the
// wishes of VII.8: density, directionality, spectrum, curvature).
enum class Quantity {
    kElevation,       // metres
    kSlope,           // degrees
    kCurvature,       // mean curvature, hollows positive (measures.cpp)
    kRelief,          // metres from low to high in a window
    kDirectionality,  // of a window's slopes: 0 all ways, 1 one way and back
    kSpectrum,        // octaves of variance from one band of a window to the next coarser
    kEdgeScale,       // metres, as all scales and lengths
    kEdgeLength,
    kEdgeStrength,  // the detector's response
    kEdgeDensity,   // percent of a window's samples
    kRidgeScale,
    kRidgeLength,
    kRidgeStrength,
    kRidgeDensity,
    kValleyScale,
    kValleyLength,
    kValleyStrength,
    kValleyDensity,
    kPeakScale,
    kPeakStrength,
    kPeakDensity
};
inline constexpr int kQuantities = 21;
inline constexpr std::array<std::string_view, kQuantities> kQuantityNames = {
    "elevation",       "slope",          "curvature",    "relief",
    "directionality",  "spectrum",       "edge scale",   "edge length",
    "edge strength",   "edge density",   "ridge scale",  "ridge length",
    "ridge strength",  "ridge density",  "valley scale", "valley length",
    "valley strength", "valley density", "peak scale",   "peak strength",
    "peak density"};

// Of a land at one level of detail.
using Analysis = std::array<Statistics, kQuantities>;

Analysis analysis_of(const Terrain& terrain);
// Of the samples where `inside` is not 0 (same shape). Slopes, windows and features are
// the whole land's, so that the region's border is none; a feature counts where more than
// half of it lies inside.
Analysis analysis_of(const Terrain& terrain, const Field<std::uint8_t>& inside);
// The same of regions 0 to count - 1 at once; other samples belong to none.
std::vector<Analysis> analyses_of(const Terrain& terrain, const Field<int>& regions,
                                  int count);

// The land with so many metres from sample to sample, its mean where that is more.
Terrain at_level(const Terrain& terrain, double spacing);

inline constexpr int kAnalysisVersion = 2;  // raised when the same land gives other ones

}  // namespace cydonia::genetic
