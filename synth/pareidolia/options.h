#pragma once

#include <optional>
#include <string>
#include <vector>

#include "field/length.h"
#include "field/noise.h"
#include "field/source.h"
#include "field/vec.h"

namespace cydonia::pareidolia {

// One image and the sun that shows it.
struct ImageOptions {
    Source target;                  // dark pixels are shadow
    std::optional<double> azimuth;  // radians; none: "auto", by the shortest longest run
    double elevation = radians(25.0);  // radians
    double min_iou = 0.85;             // the check fails below
};

enum class Solver { kFeatures };

// Rusnell 2009, table 5.1; the terrain so far is the base terrain T_b.
struct Options {
    Solver solver = Solver::kFeatures;   // always named in scene files
    std::vector<ImageOptions> images;    // exactly one for kFeatures
    double mean_edge_weight = 2.0;       // mu_w, cost per length: a slope
    double edge_weight_deviation = 1.5;  // r, 0 <= r < mu_w
    Length grain = thesis_units(8.0);    // shortest wavelength of the random weights
    int secondary_peaks = 10;
    int secondary_ridges = 75;
    NoiseOptions secondary_cost;  // C_sec, normalised between its bounds
};

}  // namespace cydonia::pareidolia
