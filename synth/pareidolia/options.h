#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/length.h"
#include "field/noise.h"
#include "field/source.h"
#include "field/vec.h"

namespace cydonia::pareidolia {

// Where the image lies on the terrain. Its proportions are kept, and at scale 1 it is as
// large as the extent allows.
struct Placing {
    // The position of its middle from the south-west corner, as shares of the extent; 0.5
    // is the middle.
    std::array<double, 2> position{0.5, 0.5};
    double scale = 1.0;
    double rotation = 0.0;  // radians, clockwise seen from above
};

// Which parts of a picture are shadow.
enum class Reading {
    kDark,        // darker than the threshold
    kAlpha,       // more opaque than the threshold
    kPhotograph,  // what a two-tone drawing of the photograph inks
};

// One image and the sun that shows it.
struct ImageOptions {
    std::optional<Source> target = {};  // a picture; or
    std::string text = {};              // a line of text
    std::string font = "DejaVu Sans Bold";
    Reading reading = Reading::kDark;
    double threshold = 0.5;  // 0 to 1
    bool invert = false;     // what would be lit is shadow
    Placing placing = {};
    // Radians; none is "auto", the azimuth whose longest shadow is shortest.
    std::optional<double> azimuth = {};
    // Radians; none is "auto", the highest sun whose longest shadow fits the height
    // budget.
    std::optional<double> elevation = radians(25.0);
    double min_iou = 0.85;  // the check fails below
};

enum class Solver {
    kFeatures,     // Rusnell 2009, Algorithm 4
    kConstrained,  // the base bent as little as the image allows
};

// What makes the lit holes of an image.
enum class Holes {
    kCrests,     // crests at every start of shadow (Rusnell 2009, section 5.3.1)
    kIterative,  // points just above the shadow line (section 5.3.2)
};

// Rusnell 2009, table 5.1; the terrain so far is the base terrain T_b.
struct FeaturesOptions {
    double mean_edge_weight = 2.0;       // mu_w, cost per length: a slope
    double edge_weight_deviation = 1.5;  // r, 0 <= r < mu_w
    Length grain = thesis_units(8.0);    // shortest wavelength of the random weights
    int secondary_peaks = 10;
    int secondary_ridges = 75;
    NoiseOptions secondary_cost;  // C_sec, normalised between its bounds
    Holes holes = Holes::kCrests;
};

// The weights of what the bent land should be; 0 leaves a goal out.
struct ConstrainedOptions {
    double faithful = 1.0;       // shadows deep and crisp, light parts bright
    double natural = 1.0;        // slopes and curvature of the base
    double hidden = 1.0;         // no trace under any other sun
    std::optional<Source> keep;  // white: the land must not change
};

struct Options {
    Solver solver = Solver::kFeatures;  // always named in scene files
    std::vector<ImageOptions> images;   // 1 to 4; exactly one for kFeatures
    // How far, in metres, the light of the longest shadow may fall; none is as far as the
    // base's relief allows.
    std::optional<double> height_budget;
    FeaturesOptions features;
    ConstrainedOptions constrained;
};

inline constexpr int kMostImages = 4;

}  // namespace cydonia::pareidolia
