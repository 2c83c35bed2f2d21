#pragma once

#include <cstdint>

#include "field/terrain.h"
#include "synth/distance/passes.h"

namespace cydonia::distance {

// Rusnell 2009, Algorithm 3, steps 1 to 4: everything that the passes run over.
struct Layout {
    Graph graph;
    Features features;  // without those at sea level, which emit nothing
    Regions regions;
    Shapes shapes;
    Halting halting;

    Ground ground() const { return {graph, features, shapes, regions}; }
};

// Throws bad_request for options that contradict the inputs.
Layout layout_of(const Options& options, const Terrain& terrain, std::uint64_t seed);

}  // namespace cydonia::distance
