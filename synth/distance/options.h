#pragma once

#include <array>
#include <optional>
#include <vector>

#include "field/length.h"
#include "field/noise.h"
#include "field/source.h"

namespace cydonia::distance {

// Cross-section of a feature, from its generator outward: monotonically decreasing. An
// image (dark line on light ground, as in figure 3.2; an SVG is drawn 512 pixels wide) or
// (x, f(x)) pairs in any unit; at most one is given. With neither, raw edge weights shape
// the land.
struct Profile {
    std::optional<Source> image;
    std::vector<std::array<double, 2>> points;
    // Horizontal length of the whole profile; by default one pixel (or unit of x) is one
    // thesis unit.
    std::optional<Length> reach;
    bool empty() const { return !image && points.empty(); }
};

// C_g(n), the cost of a generator: how far below the highest possible ground it starts.
struct CostRule {
    enum class Kind {
        kNoise,   // fBm or ridged multifractal, shifted so that the least generator costs
                  // 0
        kRandom,  // uniform in `range` for every feature
    };
    Kind kind = Kind::kNoise;
    NoiseOptions noise;
    std::array<Length, 2> range{thesis_units(0.0), thesis_units(20.0)};
};

// Random single-node features, uniform over the terrain.
struct PeakOptions {
    int count = 0;
    CostRule cost;
};

// Ridges grown by tracing the least-cost path from a random node back to the peak or
// stroke it came from, whose feature they join (thesis, section 4.1 and 5.4).
struct RidgeOptions {
    int count = 0;
    double cost_factor = 0.25;  // of the cost that the first pass gave the node
};

// Rusnell 2009, table 3.1. Lengths and costs: notes.md, Rusnell 1.
struct Options {
    std::optional<Source>
        strokes;          // F, painted or drawn; one feature a connected component
    CostRule cost;        // C_g of the strokes
    PeakOptions peaks;    // F, random
    RidgeOptions ridges;  // F, grown
    Profile profile;      // P
    double mean_edge_weight = 2.0;       // mu_w, cost per length: a slope
    double edge_weight_deviation = 1.0;  // r, 0 <= r < mu_w
    Length grain = thesis_units(4.0);    // shortest wavelength of the random weights
    double sea_level_scale = 1.1;        // s
    double blending_bias = 3.0;          // b
    Length sea_level_threshold = thesis_units(0.5);  // epsilon_s
    double approximate_threshold = 0.05;             // p_f
    double minimum_scale = 0.001;                    // min{t_s}
    enum class Metric { kEuclidean, kThesis };       // diagonal edges cost sqrt(2), or 1
    Metric metric = Metric::kEuclidean;
    int neighbours = 8;  // 8 or 16
};

}  // namespace cydonia::distance
