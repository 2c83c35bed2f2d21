#pragma once

#include <vector>

#include "field/progress.h"
#include "synth/texture/options.h"
#include "synth/texture/pyramid.h"

namespace cydonia::texture {

struct Lands {
    double spacing = 1.0;  // metres
    std::vector<Land> all;
};

// The exemplars at one spacing, with heights and types as the options ask. What was done
// to them goes to `progress`. Throws bad_request, naming the file, for one that is no
// elevation model, too small, too large, flat or all void.
Lands lands_of(const Options& options, Progress& progress);

}  // namespace cydonia::texture
