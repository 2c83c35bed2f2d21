#pragma once

#include "field/field.h"
#include "synth/distance/graph.h"
#include "synth/pareidolia/shadow_plan.h"

namespace cydonia::pareidolia {

// What multiplies a graph's edge weights at each cell, and across the light besides
// (weights from an image: thesis, section 4.3.2).
struct Slopes {
    Field<float> factor;
    double across = 1.0;
};

// Gentler than the light, so that nothing is in shadow, but steep on the far side of
// crests, for a share of each shadow.
Slopes flank_slopes(const ShadowPlan& plan, double lit, double steep, double share);
// How land may rise from where shadows end: gently, so that it casts nothing itself, but
// as it likes `inside` and in front of a crest further down the light.
Slopes end_slopes(const ShadowPlan& plan, const Field<std::uint8_t>& inside, double lit);
// How land may rise from crests toward the sun; as it likes `inside`.
Slopes crest_slopes(const ShadowPlan& plan, const Field<std::uint8_t>& inside,
                    double lit);

distance::Graph scaled(const distance::Graph& graph, const Slopes& slopes,
                       const LightFrame& frame);

// Steps 8 to 10 of Algorithm 4: one undivided pass from every generator (kNowhere: none),
// as heights. `profiles` holds each generator's constant profile where it is not empty.
Field<float> spread(const distance::Graph& graph, const Field<float>& generators,
                    const Field<float>& profiles = {});

// The same upside down: the highest land that rises no faster from the given points.
Field<float> ceiling(const distance::Graph& graph, const Field<float>& points);

// Section 5.4: what keeps the generators beside a primary one as low as they are.
Field<float> constant_profiles(const Field<float>& primary, double spacing,
                               double mean_edge_weight);

}  // namespace cydonia::pareidolia
