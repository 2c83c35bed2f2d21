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

// A finished level of detail.
struct LevelDone {
    double spacing = 0.0;  // metres
    Field<float> heights;
    int genes = 0, side = 0;
    std::vector<Generation> generations;
    // How sharply the land bends at seams between genes of different land, divided by how
    // it bends elsewhere; 0 without such seams.
    double seam_energy = 0.0;
    bool by_texture = false;
};

// Applies placed points and curves to the land of a level; may be empty.
using PlacedFeatures = std::function<void(Field<float>& heights, double spacing)>;

// Builds a height field level by level (section IV.3.3); the last level of the result is
// the land. `regions` are on the finest level's cells. `samples` go from the base level
// to the finest. Where `texture` is not null, it makes the levels finer than
// `texture_from` down to `texture_to` (metres).
std::vector<LevelDone> height_field(const Regions& regions,
                                    const std::vector<LevelSamples>& samples, int ratio,
                                    const EvolutionOptions& options,
                                    const PlacedFeatures& features,
                                    const ByTexture* texture, double texture_from,
                                    double texture_to, std::uint64_t seed,
                                    Progress& progress);

// The coarsest level with enough land for every used type and at least a few cells of
// terrain, and whose spacing is at most `coarsest`. Each level is `ratio` times finer
// than the one before, and the last has width x height cells.
int base_level(const std::vector<LevelSamples>& samples, const Regions& regions,
               int width, int height, int ratio, double coarsest);

// Regions on cells `ratio` times as wide. A cell gets the region that most of its finer
// cells have.
Regions coarser(const Regions& regions, int ratio);

}  // namespace cydonia::genetic
