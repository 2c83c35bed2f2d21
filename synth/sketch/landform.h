#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "field/field.h"
#include "synth/texture/shape.h"

namespace cydonia::sketch {

// A feature of the land by its curves (Gain, Marais and Strasser 2009, section 3): where
// it runs, how high it is, how far it reaches. Metres, from the south-west corner.
struct Landform {
    texture::Shape shadow;
    Field<float> silhouette;  // heights along the shadow from its begin to its end: a row
    // Distance of the boundaries left and right of a place along the shadow.
    std::function<std::array<double, 2>(double along)> boundary;
    bool mouse = false;  // a mouse drew the silhouette: its finest two bands are no noise
};

// Noise of a silhouette's bands: entry i - 1 for band i, metres.
struct NoiseLevels {
    std::vector<double> measured;
    std::vector<double> fitted;  // by an exponential decay, which terrain has
};
NoiseLevels noise_of(const Field<float>& silhouette, int levels, bool mouse);

// The land deformed so that it has the silhouette's heights along the shadow and is as
// rough as the silhouette is, and none of it beyond the boundary (section 4). Scale by
// scale, from what is wider than 2^levels samples on. Outside it keeps its bytes.
void deform(Field<float>& land, double spacing, const Landform& landform, int levels,
            std::uint64_t seed);

}  // namespace cydonia::sketch
