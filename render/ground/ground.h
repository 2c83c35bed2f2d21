#pragma once

#include <cstdint>

#include "field/image.h"
#include "field/terrain.h"
#include "render/options.h"

namespace cydonia::render {

// The ground as a look paints it, draped over the land: `detail` pixels a cell, so
// (detail * width) x (detail * height), pixel centres at sub-cell centres.
struct GroundMap {
    Field<Rgb> albedo;              // linear Rec.709
    Field<std::uint8_t> materials;  // what lies on top there: index into the look's
};

// By the options' look; the same look for any number of samples.
GroundMap ground_map(const Terrain& terrain, const GroundOptions& options, int detail);
// Its albedo alone.
Field<Rgb> ground_albedo(const Terrain& terrain, const GroundOptions& options,
                         int detail);

// How much of the sky each sample sees, 0 to 1, cosine weighted: same shape as the
// heights, but at most 1024 samples a side. For skylight without radiosity.
Field<float> sky_visibility(const Field<float>& heights, double spacing);

}  // namespace cydonia::render
