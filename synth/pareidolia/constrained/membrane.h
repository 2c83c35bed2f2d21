#pragma once

#include "field/field.h"

namespace cydonia::pareidolia {

// The cost of a change c of the land is half the sum over its cells of
// slope |grad c|^2 + bend (laplacian c)^2 + keep c^2.
struct Stiffness {
    double slope = 1.0, bend = 0.0, keep = 0.0;
};

// The linear part of the programme: solves (bend L^2 + slope L + keep + pull) c = force
// by cosine transforms, where L is the negated five-point Laplacian with free borders.
class Membrane {
  public:
    Membrane(int width, int height, const Stiffness& stiffness, double pull);
    // Replaces the force by the change.
    void solve(Field<float>& force) const;

  private:
    Field<float> response_;  // of every frequency, rows and columns exchanged
};

}  // namespace cydonia::pareidolia
