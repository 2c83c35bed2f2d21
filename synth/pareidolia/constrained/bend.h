#pragma once

#include <vector>

#include "synth/pareidolia/constrained/demand.h"
#include "synth/pareidolia/constrained/membrane.h"

namespace cydonia::pareidolia {

struct BendOptions {
    Stiffness stiffness;
    Stops stops = Stops::kColumns;
};

// One grid of the land while it is bent: the convex programme of least change subject to
// what every sun must see, by consensus ADMM (Boyd et al. 2011, section 7.1), linearised
// where samples mix heights: a solve for the change, and a projection on each sun's
// inequalities, in turn. What was learned stays between calls.
class Bend {
  public:
    // `land` is what changes are counted from; its cells are `cells` of the demands'
    // wide, and `spacing` metres. Where `held` is finite the land comes to that height;
    // empty: nowhere.
    Bend(Field<float> land, double spacing, double cells, Field<float> held,
         const BendOptions& options);

    // At first, and anew where margins or parts changed: the same suns in the same order.
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
