#pragma once

#include "field/image.h"
#include "field/terrain.h"
#include "render/options.h"

namespace cydonia::render {

// The ground's linear Rec.709 albedo, draped over the land: `detail` pixels a cell, so
// (detail * width) x (detail * height), pixel centres at sub-cell centres. By slope at
// two scales, height, hollows, and noise on every border; the same look for any number of
// samples.
Field<Rgb> ground_albedo(const Terrain& terrain, const GroundOptions& options,
                         int detail);

// How much of the sky each sample sees, 0 to 1, cosine weighted: same shape as the
// heights. For skylight without radiosity.
Field<float> sky_visibility(const Field<float>& heights, double spacing);

}  // namespace cydonia::render
