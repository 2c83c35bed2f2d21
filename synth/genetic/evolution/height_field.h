#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "field/field.h"
#include "synth/context.h"
#include "synth/genetic/evolution/by_texture.h"
#include "synth/genetic/evolution/evolution.h"
#include "synth/genetic/evolution/fitness.h"
#include "synth/genetic/evolution/samples.h"
#include "synth/genetic/options.h"

namespace cydonia::genetic {

// One level of detail, done.
struct LevelDone {
    double spacing = 0.0;  // metres
    Field<float> heights;
    int genes = 0, side = 0;
    std::vector<Generation> generations;
    // How sharply the land bends where two genes meet that do not go on with the same
    // land, over how it bends elsewhere; 0 without such seams.
    double seam_energy = 0.0;
    bool by_texture = false;
};

// What points and curves make of the land of a level; may be empty.
using Features = std::function<void(Field<float>& heights, double spacing)>;

// Builds a height field level by level (section IV.3.3). `regions`: on the finest level's
// cells. The last of the result is the land. `samples` coarse to fine, the first the base
// level's.
std::vector<LevelDone> height_field(const Regions& regions,
                                    const std::vector<LevelSamples>& samples, int ratio,
                                    const EvolutionOptions& options,
                                    const Features& features, const ByTexture* texture,
                                    double texture_from, double texture_to,
                                    std::uint64_t seed, Progress& progress);

// The coarsest of the levels that has land enough for every used type and at least a few
// cells of terrain: levels are `ratio` times finer from one to the next, the last
// `finest` metres; none is coarser than `coarsest`.
int base_level(const std::vector<LevelSamples>& samples, const Regions& regions,
               int width, int height, int ratio, double coarsest);

// Regions on cells `ratio` times wider, each the one that most of its cells are of.
Regions coarser(const Regions& regions, int ratio);

}  // namespace cydonia::genetic
