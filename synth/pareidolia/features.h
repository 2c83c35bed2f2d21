#pragma once

#include "field/terrain.h"
#include "synth/context.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// Rusnell 2009, Algorithm 4, steps 3 to 10, as used for TEXT (section 5.3.1) or, with
// Holes::kIterative, for the smiley (section 5.3.2): makes ridges that cast the image's
// shadows and complementary peaks and ridges, searches least-cost paths from all of them
// in one pass, and takes the maximum with the base terrain. Returns heights in metres, in
// the shape of the base.
//
// It departs from the thesis so that the land casts no other shadows and does not show
// the image by its outline alone. (The departure for holes is in shadow_lines.h.)
// Features fall more gently than the light where the ground is lit, and steeply only
// behind a crest. Land around crests and around the ends of shadows is kept so low that
// it casts no shadow beyond them; in the thesis Algorithms 5 to 7 limit the secondary
// features only. Land that would rise through a line of light inside a shadow is cut off
// below it.
Field<float> features(const Options& options, const Terrain& base,
                      const ShadowImage& image, const Context& context);

}  // namespace cydonia::pareidolia
