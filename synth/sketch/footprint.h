#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "field/field.h"
#include "synth/geometry/shape.h"

namespace cydonia::sketch {

// A feature of the land by its curves (Gain, Marais and Strasser 2009, section 3): where
// it runs, how high it is, how far it reaches. Metres, from the south-west corner.
struct Landform {
    texture::Shape shadow;
    Field<float> silhouette;  // heights along the shadow from its begin to its end: a row
    // Distance of the boundaries left and right of a place along the shadow.
    std::function<std::array<double, 2>(double along)> boundary;
    std::vector<double> noise;  // of bands 1 to m, metres
    // Whether it goes on beyond an end, over the terrain's edge or into another way of
    // the feature: no land to blend into.
    std::array<bool, 2> goes_on{};
};

// A sample of a landform's footprint: where it is along the shadow, and how far from it.
struct Foot {
    std::size_t index;
    float place;         // among the silhouette's values
    float distance;      // samples, from the shadow
    float reach;         // samples, of the boundary
    float noise = 0.0f;  // W_0: how much of the noise is the silhouette's
    float part = 1.0f;   // of the feature's landforms this one's share

    // Eq. 1, of a boundary that is a share of its own.
    float weight(float share) const;
};

// Section 4, parametrisation: on the line through the shadow's ends, which has no seams,
// and where the shadow leans away from that line too far or folds over it, on the shadow
// itself.
std::vector<Foot> footprint(const Landform& landform, const Field<float>& land,
                            double spacing);
bool lies_on_base_line(const texture::Shape& shadow);

// Divides samples that several landforms reach among them.
void share_out(std::vector<std::vector<Foot>>& feet, std::size_t samples);

}  // namespace cydonia::sketch
