#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "field/field.h"
#include "synth/sketch/footprint.h"

namespace cydonia::sketch {

// Noise of a silhouette's bands: entry i - 1 for band i, metres.
struct NoiseLevels {
    std::vector<double> measured;
    std::vector<double> fitted;  // by an exponential decay, which terrain has
};
NoiseLevels noise_of(const Field<float>& silhouette, int levels, bool mouse);
// Of a whole land.
NoiseLevels noise_of_land(const Field<float>& heights, int levels);

// Band i of the noise that landforms get (bands.h), as large as the land, of mean square
// 1.
using Noise = std::function<Field<float>(int band)>;
Noise wavelets(const Field<float>& land, int levels, std::uint64_t seed);

// The land deformed so that it has the silhouettes' heights along their shadows and is as
// rough as they are, and none of it beyond their boundaries (section 4). Scale by scale,
// from what is wider than 2^levels samples on. Outside it keeps its bytes. The landforms
// are one feature, a way and its branches: where two reach, each counts the more the
// nearer it is. Gives the feet of each.
std::vector<std::vector<Foot>> deform(Field<float>& land, double spacing,
                                      std::span<const Landform> landforms, int levels,
                                      const Noise& noise);

// Brings deformed land back onto the silhouettes.
void settle(Field<float>& land, double spacing, std::span<const Landform> landforms,
            const std::vector<std::vector<Foot>>& feet);

}  // namespace cydonia::sketch
