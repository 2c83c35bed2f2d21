#pragma once

#include "field/terrain.h"
#include "synth/context.h"
#include "synth/texture/maker.h"
#include "synth/texture/options.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// Sets down in the terrain what its synthesis was worth: errors at points and curves, the
// share of the asked types, patches and where they are from, heights that no exemplar
// has, channels that end nowhere.
void report(const Options& options, const Maker& maker, const Synthesis& land,
            Terrain& terrain, const Context& context);

}  // namespace cydonia::texture
