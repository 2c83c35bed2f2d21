#pragma once

#include "field/terrain.h"
#include "synth/context.h"
#include "synth/texture/maker.h"
#include "synth/texture/options.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// Adds to the terrain figures, masks and pictures that judge its synthesis: errors at
// points and curves, the share of cells that have the requested type, patches and where
// they come from, heights outside the exemplars' range, and channels that end nowhere.
void report(const Options& options, const Maker& maker, const Synthesis& land,
            Terrain& terrain, const Context& context);

}  // namespace cydonia::texture
