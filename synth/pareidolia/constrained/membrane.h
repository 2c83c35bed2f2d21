#pragma once

#include "field/field.h"

namespace cydonia::pareidolia {

// What a change c of the land costs: half the sum over its cells of
// slope |grad c|^2 + bend (laplacian c)^2 + keep c^2.
struct Stiffness {
    double slope = 1.0, bend = 0.0, keep = 0.0;
};

// The linear side of the programme: (bend L^2 + slope L + keep + pull) c = force with the
// five-point Laplacian L, negated, and free borders, by cosine transforms.
class Membrane {
  public:
    Membrane(int width, int height, const Stiffness& stiffness, double pull);
    // In place: the force becomes the change.
    void solve(Field<float>& force) const;

  private:
    Field<float> response_;  // of every frequency, rows and columns exchanged
};

}  // namespace cydonia::pareidolia
