#include <fmt/format.h>

#include "config/reader/readers.h"

namespace cydonia::config {

using pareidolia::ConstrainedOptions;
using pareidolia::FeaturesOptions;
using pareidolia::Holes;
using pareidolia::ImageOptions;
using pareidolia::Options;
using pareidolia::Solver;

namespace {

constexpr Name<Solver> kSolvers[] = {
    {"features", Solver::kFeatures},
    {"constrained", Solver::kConstrained},
};

constexpr Name<pareidolia::Reading> kReadings[] = {
    {"dark", pareidolia::Reading::kDark},
    {"alpha", pareidolia::Reading::kAlpha},
    {"photograph", pareidolia::Reading::kPhotograph},
};

constexpr Name<Holes> kHoles[] = {
    {"crests", Holes::kCrests},
    {"iterative", Holes::kIterative},
};

constexpr std::size_t kMostTables = 64;  // more images than make sense are told apart
constexpr int kMostFeatures = 1000000;
constexpr std::size_t kLongestLine = 256;
constexpr Range kPriorities = from(0.0, 10.0);

// Reads the sun of an image. The method chooses the angles that are left out.
struct ImageSun {
    std::optional<double>& azimuth;
    std::optional<double>& elevation;
};

void read(Table& t, ImageSun& sun) {
    t.field("azimuth", sun.azimuth, kAzimuth, "auto");
    t.field("elevation", sun.elevation, SunElevation{}, "auto");
}

void read_what(Table& t, ImageOptions& image) {
    t.field("target", image.target, File{});
    t.field("text", image.text, Text{kLongestLine});
    t.field("font", image.font, Text{});
    t.field("reading", image.reading, one_of(kReadings));
    t.field("threshold", image.threshold, Number{between(0.0, 1.0)});
    t.field("invert", image.invert, Flag{});

    t.check(t.has("target") != t.has("text"), {"target", "text"},
            "needs exactly one of target and text");
    const bool blank = image.text.find_first_not_of(' ') == std::string::npos;
    t.check(!t.has("text") || !blank, {"text"}, "a line of text without a letter");
    t.only_if(t.has("text"), {"font"}, "an image with text");
    t.only_if(t.has("target"), {"reading", "threshold"}, "an image with target");
}

}  // namespace

void read(Table& t, ImageOptions& image) {
    read_what(t, image);
    t.field("position", image.placing.position, Number{from(-1.0, 2.0)});
    t.field("scale", image.placing.scale, Number{above_to(0.0, 4.0)});
    t.field("rotation", image.placing.rotation, kAzimuth);
    ImageSun sun{image.azimuth, image.elevation};
    t.table("sun", sun);
    t.field("min_iou", image.min_iou, Number{from(0.0, 1.0)});
}

namespace {

void read_features(Table& t, FeaturesOptions& f, bool used) {
    t.field("mean_edge_weight", f.mean_edge_weight, Number{above_to(0.0, 1000.0)});
    t.field("edge_weight_deviation", f.edge_weight_deviation, Number{from(0.0, 1000.0)});
    t.field("grain", f.grain, LengthUnit{above(0.0)});
    t.field("secondary_peaks", f.secondary_peaks, Whole{0, kMostFeatures});
    t.field("secondary_ridges", f.secondary_ridges, Whole{0, kMostFeatures});
    t.table("secondary_cost", f.secondary_cost);
    t.field("holes", f.holes, one_of(kHoles));
    check_edge_weights(t, f.mean_edge_weight, f.edge_weight_deviation);
    t.only_if(used,
              {"mean_edge_weight", "edge_weight_deviation", "grain", "secondary_peaks",
               "secondary_ridges", "secondary_cost", "holes"},
              "solver = \"features\"");
}

void read_constrained(Table& t, ConstrainedOptions& c, bool used) {
    t.field("faithful", c.faithful, Number{kPriorities});
    t.field("natural", c.natural, Number{kPriorities});
    t.field("hidden", c.hidden, Number{kPriorities});
    t.field("keep", c.keep, File{});
    t.only_if(used, {"faithful", "natural", "hidden", "keep"},
              "solver = \"constrained\"");
}

}  // namespace

void read(Table& t, Options& o) {
    const bool known = t.required("solver", o.solver, one_of(kSolvers));
    t.tables("image", o.images, kMostTables);
    t.field("height_budget", o.height_budget, Number{above_to(0.0, 1e5)});
    read_features(t, o.features, !known || o.solver == Solver::kFeatures);
    read_constrained(t, o.constrained, !known || o.solver == Solver::kConstrained);

    const std::size_t images = o.images.size();
    t.check(!known || o.solver != Solver::kFeatures || images == 1, {"image"},
            fmt::format("the features solver shows exactly one image, found {}; "
                        "solver = \"constrained\" shows up to {}",
                        images, pareidolia::kMostImages));
    t.check(!known || o.solver != Solver::kConstrained || images >= 1, {"image"},
            "there is no image to show; add at least one [[terrain.stage.image]]");
    t.check(o.solver != Solver::kConstrained || images <= pareidolia::kMostImages,
            {"image"},
            fmt::format("at most {} images share one land, found {}",
                        pareidolia::kMostImages, images));
}

}  // namespace cydonia::config
