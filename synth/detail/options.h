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

// What details are (section 5.1): the targets' own; noise that is as strong as those are
// where they were found; or noise of one strength and H, as strong as the targets'
// coarsest details, which knows no place (Miller 1986; Voss 1985).
enum class Kind { kCopied, kMultifractal, kFractal };
inline constexpr double kHurst = 0.85;  // H of the last

// Real land whose details are taken.
struct Target {
    Source source;
    // Where it is painted in Options::paint; without a painting it is used everywhere.
    std::optional<std::array<std::uint8_t, 3>> colour = {};
    double scale = 1.0;  // stretches it sideways
};

// A part of the land that takes its details from one part of a target, as shares of both
// from their south-west corners.
struct Mapping {
    int target = 1;                          // its number in the list, from 1
    std::array<double, 2> from{0.5, 0.5};    // middle in the target
    std::array<double, 2> to{0.5, 0.5};      // middle in the land
    std::array<double, 2> size{0.25, 0.25};  // of the land
    // In the land, instead of `to` and `size`.
    std::vector<std::array<double, 2>> outline = {};
};

// Brosz, Samavati and Sousa, "Terrain Synthesis By-Example", 2007.
struct Options {
    std::vector<Target> targets;
    int levels = 3;         // of detail that are taken, the finest and the next
    double strength = 1.0;  // times the details
    Filter filter = Filter::kChaikin;
    Search search = Search::kRandom;
    Kind kind = Kind::kCopied;
    double block = 1.0 / 15.0;  // side of a block as a share of the land's mean side
    // Details as much stronger or weaker than the target's as the land is rougher or
    // calmer than the target one level above those that are taken. For real land, which
    // tells.
    bool adapt = false;
    int candidates = 40;   // tried for a block where they are at random
    int orientations = 1;  // 1, 4 or 8: blocks of the targets also turned, mirrored
    std::vector<Mapping> mappings;  // instead of a search: only there
    std::optional<Source> paint;    // in the targets' colours; elsewhere the land stays
};

}  // namespace cydonia::detail
