#pragma once

#include <cstdint>

#include "field/terrain.h"
#include "render/fine_relief/options.h"
#include "render/options.h"

namespace cydonia::render {

// Must be raised whenever the heights change.
inline constexpr int kFineReliefVersion = 1;

// How many times finer land with `samples` along its longer side is drawn: the options'
// factor, or else a power of two that suits the quality.
int fine_factor(const FineReliefOptions& options, int samples, Quality quality);

// The land with `factor` (a power of two) times the samples each way, and with form that
// is too fine for its own samples. The form is added octave by octave, each on the land
// that the octaves before it made, so that small gullies run down the sides of large
// ones. The first octave has the wavelength at which the land has less form than real
// land, the last one a wavelength of four fine samples. More samples add octaves and keep
// the others. Water stays level and its bed unchanged. Masks and shadow images keep their
// places.
Terrain with_fine_relief(const Terrain& terrain, const FineReliefOptions& options,
                         int factor, std::uint64_t seed);

}  // namespace cydonia::render
