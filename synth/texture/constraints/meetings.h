#pragma once

#include <vector>

#include "synth/texture/constraints/junctions.h"

namespace cydonia::texture {

// Where two constraints, or two parts of one curve, come together: constraints count from
// 0, spikes first.
struct Meeting {
    int first, second;  // first <= second
    double along[2];    // metres along either; 0 for a spike
    Point2 at;
};

// All crossings of curves, and every end of a curve and every spike within half a cell of
// another constraint: one for all that is within a cell, sorted by second, along it, then
// first. Throws bad_request above kMostMeetings.
inline constexpr std::size_t kMostMeetings = 20'000;
std::vector<Meeting> meetings_of(const std::vector<Spike>& spikes,
                                 const std::vector<Strand>& strands, double cell);

}  // namespace cydonia::texture
