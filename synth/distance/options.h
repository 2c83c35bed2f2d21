#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "field/length.h"
#include "field/noise.h"
#include "field/source.h"

namespace cydonia::distance {

// In pictures, what is drawn dark on light or transparent ground counts. They are
// stretched over the terrain.

// A drawn curve: a dark line in a picture (figure 3.2; an SVG is drawn 512 pixels wide),
// a table of "x, f(x)" lines (.csv), or pairs. At most one is given.
struct Curve {
    std::optional<Source> image, table;
    std::vector<std::array<double, 2>> points;
    bool empty() const { return !image && !table && points.empty(); }
};

// P: the cross-section of a feature, from its generator outward: monotonically
// decreasing.
struct Profile {
    std::string name;  // by which groups ask for it
    Curve curve;
    // Horizontal length of the whole profile; by default one pixel (or unit of x) is one
    // thesis unit.
    std::optional<Length> reach;
    // Rock strata, the stair of a profile with few levels (sections 4.2.2 and 6.2):
    // `layers` from top to foot, each a cliff over a ledge; hardness 0 none, 1 steps.
    struct Strata {
        int layers = 0;  // 0: as drawn
        double hardness = 0.7;
    } strata;
    // Fine relief on the slope, still monotone (section 4.5): 0 none, 1 as much as there
    // can be.
    double detail = 0.0;
};

// C_g(n), the cost of a generator: its depth below the highest possible ground.
struct CostRule {
    enum class Kind {
        kNoise,     // fBm or ridged multifractal, its least over the land at 0
        kRandom,    // uniform, one draw a feature
        kPainted,   // `image`: black is least
        kDrawn,     // `curve` along the stroke, from its western end: its top is least
        kGaussian,  // eq. 4.2, across the feature towards `azimuth`; greatest where it
                    // begins
        kDistance,  // from `centre`; greatest in the farthest corner
        kTerrain,   // depth below the highest point of the terrain so far
        kMinimum,   // the least of `of`
        kSum,       // the sum of `of`
    };
    Kind kind = Kind::kNoise;
    NoiseOptions noise;
    std::optional<Source> image;
    Curve curve;
    std::array<Length, 2> centre{of_width(0.5), of_width(0.5)};  // from the south-west
    double azimuth = 1.5707963267948966;                         // radians from north
    std::vector<CostRule> of;
    bool inverted = false;  // greatest and least change places

    // The costs where the rule is least and where it is greatest: absolute, or as shares
    // of a reference (eq. 4.1). With neither, noise and terrain are used as they are, and
    // other rules go from 0 to 20 thesis units.
    std::optional<std::array<Length, 2>> range;
    std::optional<std::array<double, 2>> share;
    // The reference: the rule's own greatest cost when this is empty, the greatest cost
    // of a group before, or with "approximate" the mean approximate cost under the stroke
    // (section 4.2.5).
    std::string share_of;
    Length less;  // taken off that reference
};

// Where random features may lie.
struct Placement {
    int count = 0;
    std::optional<double> density;   // features a square kilometre, instead of a count
    std::optional<Source> keep_out;  // drawn; greys are kept clear in part
    Length apart;                    // least distance between two of the group
    struct Away {
        std::string from;  // a group before
        Length distance;
    };
    std::vector<Away> away;
};

// F: where the features of a group are. A group has one of the following.

// Painted or drawn strokes: each connected component of a colour is one feature.
struct Strokes {
    Source image;
    // With a colour only strokes of that colour, and every colour of the picture needs a
    // group. Without one, everything that is drawn.
    std::optional<std::array<std::uint8_t, 3>> colour;
};
// Random single nodes.
struct Peaks {
    Placement placement;
};
// Rims with radii drawn from an interval, roughened by noise.
struct Circles {
    Placement placement;
    std::array<Length, 2> radius{thesis_units(8.5), thesis_units(85.3)};
    double roughness = 0.1;  // greatest deviation, as a share of the radius
};
// Sobel edges of any picture, eq. 4.3.
struct Edges {
    Source image;
    double threshold = 0.5;  // t_g, from the least gradient to the greatest
};
// Levels of path cost from drawn strokes, as shares of the greatest (A.2.8). Each level
// is one feature; the first is farthest from the strokes.
struct Terraces {
    Source image;
    struct Level {
        std::array<double, 2> range{0.0, 1.0};  // above the first, up to the second
        Length cost;                            // of its generators
    };
    std::vector<Level> levels;
};
// The line at a given path length from drawn strokes (A.2.9).
struct Lip {
    Source image;
    Length distance = thesis_units(8.0);
};

// Ridges grown by tracing the least-cost path from random nodes back to a feature, which
// they join (sections 4.1 and 5.4).
struct Ridges {
    int count = 0;
    double cost_factor = 0.25;      // of the cost that the path's nodes had
    std::optional<Length> reach;    // from the generators, at most
    std::vector<std::string> from;  // groups so far; empty: this one
};

struct Group {
    std::string name;
    std::variant<Strokes, Peaks, Circles, Edges, Terraces, Lip> where;
    CostRule cost;                     // not of terraces, whose levels have theirs
    std::vector<std::string> profile;  // several: feature i takes the i-th, in turn;
                                       // none: raw edge weights shape the land
    // The profile on the right of an open stroke, seen from its western end, or outside
    // a closed one; `profile` is then that of its other side.
    std::string other_side;
    Ridges ridges;
};

// A part of the land with rules of its own. Where two overlap, the later one holds.
struct RegionOptions {
    std::optional<Source> image;  // drawn, or
    std::string inside;           // what the closed strokes of this group enclose
    std::string profile;          // the one profile that holds there; empty: each its own
    std::vector<std::string> only;       // groups that blend there; empty: all
    Length feather = thesis_units(3.0);  // over which the others fade out, inwards
};

// A sea or lake (section 6.2): the land falls to its drawn shore and continues beneath
// the water.
struct Water {
    Source image;                           // drawn
    std::optional<Length> level{Length{}};  // of the surface above 0; none: the lowest
                                            // land of the shore without the water
    Length depth = thesis_units(20.0);      // below the surface at the foot of `bed`
    std::string bed = "bowl";               // profile from the shore inwards
    double shore_slope = 0.5;               // the steepest that the land rises from it
};

// A number that varies over the land with the grey of a picture, from black to white.
struct Map {
    Source image;
    std::array<double, 2> range{0.0, 1.0};
};

// Rusnell 2009, table 3.1. Lengths and costs: docs/papers.md, Rusnell 1.
struct Options {
    std::vector<Group> groups;      // F, C_g
    std::vector<Profile> profiles;  // P
    std::vector<RegionOptions> regions;
    std::vector<Water> water;

    double mean_edge_weight = 2.0;            // mu_w, cost per length: a slope
    std::optional<Map> mean_edge_weight_map;  //
    double edge_weight_deviation = 1.0;       // r, 0 <= r < mu_w
    std::optional<Map> edge_weight_deviation_map;
    // Weights from a picture (section 4.3.2): mu_w and r do not apply.
    std::optional<Map> edge_weights;
    Length grain = thesis_units(4.0);           // shortest wavelength of random weights
    enum class Metric { kEuclidean, kThesis };  // diagonal edges cost sqrt(2), or 1
    Metric metric = Metric::kEuclidean;
    int neighbours = 8;  // 8 or 16

    double sea_level_scale = 1.1;  // s
    double blending_bias = 3.0;    // b
    std::optional<Map> blending_bias_map;
    Length sea_level_threshold = thesis_units(0.5);  // epsilon_s
    double approximate_threshold = 0.05;             // p_f
    double minimum_scale = 0.001;                    // min{t_s}

    double vertical_scale = 1.0;            // of the result
    enum class Combine { kAdd, kReplace };  // with the terrain so far
    Combine combine = Combine::kAdd;
    bool preview = false;  // the approximate terrain only: one pass, with seams
};

}  // namespace cydonia::distance
