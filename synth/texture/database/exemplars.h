#pragma once

#include <vector>

#include "field/progress.h"
#include "field/terrain.h"
#include "synth/texture/database/pyramid.h"
#include "synth/texture/options.h"

namespace cydonia::texture {

struct Lands {
    double spacing = 1.0;  // metres
    std::vector<Land> all;
};

// An exemplar as it was read, cut to its window, scaled and raised.
struct Model {
    Terrain terrain;
    Field<std::uint8_t> voids;  // 1: interpolated; empty: nowhere
};
Model model_of(const Exemplar& exemplar, Progress& progress);
// The model resampled to cells of another size. As many cells as fit are centred on it.
Model resampled(const Model& model, double spacing);

// The exemplars at one spacing, with the heights and types that the options ask for. Says
// in `progress` what was done to them. Throws bad_request, which names the file, for an
// exemplar that is no elevation model, too small, too large, flat or all void.
Lands lands_of(const Options& options, Progress& progress);

}  // namespace cydonia::texture
