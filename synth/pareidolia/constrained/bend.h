#pragma once

#include <vector>

#include "synth/pareidolia/constrained/demand.h"
#include "synth/pareidolia/constrained/membrane.h"

namespace cydonia::pareidolia {

struct BendOptions {
    Stiffness stiffness;
    Stops stops = Stops::kColumns;
};

// One grid of the land while it is bent. It solves the convex programme of least change
// subject to the inequalities of every sun by consensus ADMM (Boyd et al. 2011, section
// 7.1), linearised where samples mix heights: it alternates between solving for the
// change and projecting on each sun's inequalities. The dual variables are kept between
// calls.
class Bend {
  public:
    // Changes are relative to `land`, whose cells are `cells` of the demands' cells and
    // `spacing` metres wide. Where `held` is finite the land must have that height; an
    // empty `held` holds nothing.
    Bend(Field<float> land, double spacing, double cells, Field<float> held,
         const BendOptions& options);

    // Must be called first, and again when margins or parts have changed, with the same
    // suns in the same order.
    void demand(const std::vector<Demand>& demands);
    void run(int iterations);
    Field<float> heights() const;

  private:
    struct Sight {  // of one sun
        LightRows rows;
        Records records;
        Field<float> samples;  // A h
        Field<float> nearest;  // z: the same, as it must be
        Field<float> dual;     // u: the sum of what they disagreed in
        Field<float> excess;   // A h - z + u
    };
    void project(Sight& sight) const;
    Field<float> force(float pull) const;
    void hold();

    Field<float> land_, change_;
    double spacing_, cells_;
    Field<float> held_, held_dual_;
    BendOptions options_;
    std::vector<Sight> sights_;
};

}  // namespace cydonia::pareidolia
