#pragma once

#include <string>
#include <vector>

#include "field/progress.h"
#include "synth/texture/constraints/strand.h"

namespace cydonia::texture {

// A point constraint, ready to be asked.
struct Spike {
    std::string name;
    Point2 at{};
    double height = 0.0;  // metres
    Point2 gradient{};    // rise over run towards east and north
    double radius = 0.0;  // metres

    Asked asked(const Point2& p) const {
        const Point2 v = from_to(at, p);
        return {height + dot(gradient, v), length(v), radius};
    }
};

// Where constraints cross or touch there is a junction, which has one height: a curve
// that crosses itself takes the mean of its two; between constraints the earlier one's
// holds (points come before curves) and the later one is bent to it, smoothly over twice
// its area of effect, at least twice the difference and at most as far as its next
// handle. Warns, once a pair, where they differ by more than a tenth of a cell, and says
// which won. Throws bad_request where curves are one tangle.
void join(std::vector<Spike>& spikes, std::vector<Strand>& strands, const Ground& ground,
          Progress& progress);

}  // namespace cydonia::texture
