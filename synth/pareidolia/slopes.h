#pragma once

#include "field/field.h"
#include "synth/distance/graph.h"
#include "synth/pareidolia/shadow_plan.h"

namespace cydonia::pareidolia {

// The factors of a graph's edge weights at each cell, and across the light
// (weights from an image: thesis, section 4.3.2).
struct Slopes {
    Field<float> factor;
    double across = 1.0;
};

// Slopes that are gentler than the light, so that nothing is in shadow, but steep on the
// far side of crests over a share of each shadow.
Slopes flank_slopes(const ShadowPlan& plan, double lit, double steep, double share);
// The slopes at which land may rise from the ends of shadows: gentle, so that it casts no
// shadow itself, but without a limit `inside` and in front of a crest further along the
// light.
Slopes end_slopes(const ShadowPlan& plan, const Field<std::uint8_t>& inside, double lit);
// The slopes at which land may rise from crests towards the sun, without a limit
// `inside`.
Slopes crest_slopes(const ShadowPlan& plan, const Field<std::uint8_t>& inside,
                    double lit);

distance::Graph scaled(const distance::Graph& graph, const Slopes& slopes,
                       const LightFrame& frame);

// Steps 8 to 10 of Algorithm 4: one pass from all generators together, as heights. A cell
// that is kNowhere is no generator. `profiles`, unless it is empty, holds the constant
// profile of each generator.
Field<float> spread(const distance::Graph& graph, const Field<float>& generators,
                    const Field<float>& profiles = {});

// The same upside down: the highest land that rises no faster than that from the given
// points.
Field<float> ceiling(const distance::Graph& graph, const Field<float>& points);

// Section 5.4: constant profiles that keep the generators beside a primary one at their
// own, low heights.
Field<float> constant_profiles(const Field<float>& primary, double spacing,
                               double mean_edge_weight);

}  // namespace cydonia::pareidolia
