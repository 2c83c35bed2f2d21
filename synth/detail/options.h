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

// Which candidates for a block's match are tried (section 5.2): some at random, all, or
// some and those of its neighbours.
enum class Search { kRandom, kExhaustive, kPatchMatch };

// What details are (section 5.1): the targets' own; noise as strong as these are where
// they were found; or noise of one strength and H everywhere, as strong as the targets'
// coarsest details (Miller 1986; Voss 1985).
enum class Kind { kCopied, kMultifractal, kFractal };
inline constexpr double kHurst = 0.85;  // H of kFractal

// Real land from which details are taken.
struct Target {
    Source source;
    // Its colour in Options::paint. Without a painting the target is used everywhere.
    std::optional<std::array<std::uint8_t, 3>> colour = {};
    double scale = 1.0;  // stretches it horizontally
};

// A part of the land that takes its details from a given part of a target. Positions are
// shares from the south-west corner of each.
struct Mapping {
    int target = 1;                          // number in the list of targets, from 1
    std::array<double, 2> from{0.5, 0.5};    // centre in the target
    std::array<double, 2> to{0.5, 0.5};      // centre in the land
    std::array<double, 2> size{0.25, 0.25};  // shares of the land
    // A polygon in the land, instead of `to` and `size`.
    std::vector<std::array<double, 2>> outline = {};
};

// Brosz, Samavati and Sousa, "Terrain Synthesis By-Example", 2007.
struct Options {
    std::vector<Target> targets;
    int levels = 3;         // of detail that are replaced, from the finest on
    double strength = 1.0;  // factor of the details
    Filter filter = Filter::kChaikin;
    Search search = Search::kRandom;
    Kind kind = Kind::kCopied;
    double block = 1.0 / 15.0;  // side, as a share of the land's mean side
    // Makes details stronger or weaker than the target's by as much as the land is
    // rougher or calmer than the target on the level above those that are replaced. For
    // real land, whose roughness is known.
    bool adapt = false;
    int candidates = 40;   // tried for each block, except with kExhaustive
    int orientations = 1;  // 1, 4 or 8: turned and mirrored targets are used, too
    std::vector<Mapping> mappings;  // instead of a search; details change only there
    std::optional<Source> paint;    // in the targets' colours; elsewhere nothing changes
};

}  // namespace cydonia::detail
