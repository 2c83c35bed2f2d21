#pragma once

#include <cstdint>

#include "field/terrain.h"
#include "render/fine_relief/options.h"
#include "render/options.h"

namespace cydonia::render {

// Raise it when the heights change.
inline constexpr int kFineReliefVersion = 1;

// How much finer land of so many samples along its longer side is drawn: what the options
// say; else a power of two up to a side that suits the quality.
int fine_factor(const FineReliefOptions& options, int samples, Quality quality);

// The land with `factor` times the samples each way (a power of two) and, between them,
// form that its samples are too far apart to hold: octave by octave, each drawn on the
// land that the octaves before it made, so that small gullies run down the sides of large
// ones. It begins at the wavelength from which the land has too little of its own to be
// real, and ends at four fine samples. More samples add octaves and keep the others.
// Water stays level and its bed as it is. Masks and shadow images keep their places.
Terrain with_fine_relief(const Terrain& terrain, const FineReliefOptions& options,
                         int factor, std::uint64_t seed);

}  // namespace cydonia::render
