#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "field/source.h"

namespace cydonia::detail {

// Which subdivision is reversed (Brosz 2007, section 4). Chaikin's is the paper's: its
// coarse land is smooth, and a level of detail belongs to one place.
enum class Filter { kChaikin, kHaar, kFaber, kCubic };

// How blocks of the land find theirs in the targets (section 5.2): some at random, every
// one, or some and their neighbours'.
enum class Search { kRandom, kExhaustive, kPatchMatch };

// What becomes of the details that were found (section 5.1): they are copied, or noise as
// strong as they are takes their place.
enum class Noise { kCopied, kMultifractal };

// Real land whose details are taken.
struct Target {
    Source source;
    // Where it is painted in Options::paint; without a painting it is used everywhere.
    std::optional<std::array<std::uint8_t, 3>> colour = {};
};

// A part of the land that takes its details from one part of a target. As shares of both:
// the middle, from the south-west corner.
struct Mapping {
    int target = 1;                          // its number in the list, from 1
    std::array<double, 2> from{0.5, 0.5};    // middle in the target
    std::array<double, 2> to{0.5, 0.5};      // middle in the land
    std::array<double, 2> size{0.25, 0.25};  // shares of the land
};

// Brosz, Samavati and Sousa, "Terrain Synthesis By-Example", 2007.
struct Options {
    std::vector<Target> targets;
    int levels = 3;         // of detail that are taken, the finest and the next
    double strength = 1.0;  // times the details
    Filter filter = Filter::kChaikin;
    Search search = Search::kRandom;
    Noise noise = Noise::kCopied;
    double block = 1.0 / 15.0;  // side of a block as a share of the land's mean side
    int candidates = 40;        // tried for a block where they are at random
    int orientations = 1;       // 1, 4 or 8: blocks of the targets also turned, mirrored
    std::vector<Mapping> mappings;  // instead of a search: only there
    std::optional<Source> paint;    // in the targets' colours; elsewhere the land stays
};

}  // namespace cydonia::detail
