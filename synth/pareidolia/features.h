#pragma once

#include "field/terrain.h"
#include "synth/context.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// Rusnell 2009, Algorithm 4, steps 3 to 10, as used for TEXT (section 5.3.1) or, with
// Holes::kIterative, for the smiley (section 5.3.2): ridges that cast the image's
// shadows, complementary peaks and ridges, one pass of least-cost paths from all of them,
// and the maximum with the base terrain. Heights in metres, same shape as the base.
//
// Departures (and that of holes, shadow_lines.h), for land that casts nothing else and
// does not show the image by its outline alone: features fall more gently than the light
// where the ground is lit, and steeply only behind a crest; land around crests and around
// the ends of shadows is held down to where neither throws a shadow further (Algorithms 5
// to 7 hold the secondary features only); and what rises through a line of light inside a
// shadow is cut below it.
Field<float> features(const Options& options, const Terrain& base,
                      const ShadowImage& image, const Context& context);

}  // namespace cydonia::pareidolia
