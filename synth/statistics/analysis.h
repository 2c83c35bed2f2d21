#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "field/terrain.h"
#include "synth/statistics/statistics.h"

namespace cydonia::statistics {

// The quantities whose distributions characterise a kind of land (Saunders 2006, section
// IV.3.2, and from its wishes in VII.8 density, directionality, spectrum and curvature).
enum class Quantity {
    kElevation,       // metres
    kSlope,           // degrees
    kCurvature,       // mean curvature, hollows positive (measures.cpp)
    kRelief,          // of a window, from its lowest to its highest point, metres
    kDirectionality,  // of a window's slopes: 0: all directions, 1: one
    kSpectrum,        // log2 of the ratio of variances of two successive bands
    kEdgeScale,       // all scales and lengths are in metres
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

// The statistics of each quantity, for a land at one level of detail.
using Analysis = std::array<Statistics, kQuantities>;

Analysis analysis_of(const Terrain& terrain);
// Of the samples where `inside`, which has the land's shape, is not 0. Slopes, windows
// and features are computed on the whole land, so that the border of `inside` has no
// effect on them. A feature counts if more than half of it lies inside.
Analysis analysis_of(const Terrain& terrain, const Field<std::uint8_t>& inside);
// The same for regions 0 to count - 1 at once. Samples with other numbers belong to none.
std::vector<Analysis> analyses_of(const Terrain& terrain, const Field<int>& regions,
                                  int count);

// The land resampled to a spacing in metres; where that is coarser, samples are means.
Terrain at_level(const Terrain& terrain, double spacing);

inline constexpr int kAnalysisVersion = 2;  // raised when the same land gives another one

}  // namespace cydonia::statistics
