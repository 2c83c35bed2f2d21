#pragma once

#include <cstdint>

#include "field/image.h"
#include "field/terrain.h"
#include "render/options.h"

namespace cydonia::render {

// The ground as a look paints it, draped over the land with `detail` x `detail` pixels a
// cell; pixel centres are sub-cell centres.
struct GroundMap {
    Field<Rgb> albedo;              // linear Rec.709
    Field<std::uint8_t> materials;  // the topmost material, as an index into the look's
};

// Paints the ground with the look of the options, which looks the same for any number of
// samples.
GroundMap ground_map(const Terrain& terrain, const GroundOptions& options, int detail);
// The albedo of ground_map() alone.
Field<Rgb> ground_albedo(const Terrain& terrain, const GroundOptions& options,
                         int detail);

// The cosine-weighted share of the sky that each sample sees, 0 to 1, for skylight
// without radiosity. It has the shape of the heights, or at most 1024 samples a side.
Field<float> sky_visibility(const Field<float>& heights, double spacing);

}  // namespace cydonia::render
