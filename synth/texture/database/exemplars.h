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

// An exemplar as it is read: its window, scaled and raised.
struct Model {
    Terrain terrain;
    Field<std::uint8_t> voids;  // 1: interpolated; empty: nowhere
};
Model model_of(const Exemplar& exemplar, Progress& progress);
// On cells of another size, as many as fit, the rest shared between opposite edges.
Model resampled(const Model& model, double spacing);

// The exemplars at one spacing, with heights and types as the options ask. What was done
// to them goes to `progress`. Throws bad_request, naming the file, for one that is no
// elevation model, too small, too large, flat or all void.
Lands lands_of(const Options& options, Progress& progress);

}  // namespace cydonia::texture
