#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "field/field.h"
#include "synth/sketch/footprint.h"

namespace cydonia::sketch {

// The strength of a silhouette's bands, as deviations in metres: entry i - 1 is for band
// i.
struct NoiseLevels {
    std::vector<double> measured;
    std::vector<double> fitted;  // an exponential decay, as terrain has
};
NoiseLevels noise_of(const Field<float>& silhouette, int levels, bool mouse);
// The same of a whole land.
NoiseLevels noise_of_land(const Field<float>& heights, int levels);

// Gives band i of the noise of landforms (bands.h), as large as the land and with a mean
// square of 1.
using Noise = std::function<Field<float>(int band)>;
Noise wavelets(const Field<float>& land, int levels, std::uint64_t seed);

// Deforms the land so that it has the silhouettes' heights along their shadows and their
// roughness (section 4). This works scale by scale, from 2^levels samples down. Beyond
// the boundaries the land keeps its bytes. The landforms are one feature, a way and its
// branches; where several reach, the nearer ones count more. Returns the feet of each
// landform.
std::vector<std::vector<Foot>> deform(Field<float>& land, double spacing,
                                      std::span<const Landform> landforms, int levels,
                                      const Noise& noise);

// Brings deformed land back onto the silhouettes.
void settle(Field<float>& land, double spacing, std::span<const Landform> landforms,
            const std::vector<std::vector<Foot>>& feet);

}  // namespace cydonia::sketch
