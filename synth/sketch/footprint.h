#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "field/field.h"
#include "synth/geometry/shape.h"

namespace cydonia::sketch {

// A landform given by its curves (Gain, Marais and Strasser 2009, section 3): where it
// runs, how high it is and how far it reaches. Positions are metres from the south-west
// corner.
struct Landform {
    geometry::Shape shadow;
    Field<float> silhouette;  // one row of heights along the whole shadow
    // The distances of the boundaries to the left and right of a position along the
    // shadow.
    std::function<std::array<double, 2>(double along)> boundary;
    std::vector<double> noise;  // deviations of bands 1 to m, metres
    // Whether the landform continues beyond each end, over the terrain's edge or into
    // another way of the feature, so that there is no land to blend into.
    std::array<bool, 2> goes_on{};
};

// A sample of a landform's footprint: its position along the shadow and its distance from
// it.
struct Foot {
    std::size_t index;
    float place;         // position among the silhouette's values
    float distance;      // from the shadow, samples
    float reach;         // of the boundary from the shadow, samples
    float noise = 0.0f;  // W_0, the share of the silhouette's noise
    float part = 1.0f;   // this landform's share among those of the feature

    // Eq. 1, for a boundary at a share of the whole one.
    float weight(float share) const;
};

// The parametrisation of section 4: along the line through the shadow's ends, which has
// no seams, or, where the shadow leans too far from that line or folds over it, along the
// shadow itself.
std::vector<Foot> footprint(const Landform& landform, const Field<float>& land,
                            double spacing);
bool lies_on_base_line(const geometry::Shape& shadow);

// Divides samples that several landforms reach among these.
void share_out(std::vector<std::vector<Foot>>& feet, std::size_t samples);

}  // namespace cydonia::sketch
