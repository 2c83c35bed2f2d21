#include <fmt/format.h>

#include "config/reader/readers.h"

namespace cydonia::config {

using pareidolia::ImageOptions;
using pareidolia::Options;
using pareidolia::Solver;

namespace {

constexpr Name<Solver> kSolvers[] = {
    {"features", Solver::kFeatures},
    {"constrained", Solver::kConstrained},
};

constexpr std::size_t kMostImages = 64;
constexpr int kMostFeatures = 1000000;

// The sun of an image: its azimuth may be left to the method.
struct ImageSun {
    std::optional<double>& azimuth;
    std::optional<double>& elevation;
};

void read(Table& t, ImageSun& sun) {
    t.field("azimuth", sun.azimuth, kAzimuth, "auto");
    t.field("elevation", sun.elevation, SunElevation{}, "auto");
}

}  // namespace

void read(Table& t, ImageOptions& image) {
    t.field("target", image.target, File{});
    ImageSun sun{image.azimuth, image.elevation};
    t.table("sun", sun);
    t.field("min_iou", image.min_iou, Number{from(0.0, 1.0)});
}

void read(Table& t, Options& o) {
    t.required("solver", o.solver, one_of(kSolvers));
    t.tables("image", o.images, kMostImages);
    pareidolia::FeaturesOptions& f = o.features;
    t.field("mean_edge_weight", f.mean_edge_weight, Number{above_to(0.0, 1000.0)});
    t.field("edge_weight_deviation", f.edge_weight_deviation, Number{from(0.0, 1000.0)});
    t.field("grain", f.grain, LengthUnit{above(0.0)});
    t.field("secondary_peaks", f.secondary_peaks, Whole{0, kMostFeatures});
    t.field("secondary_ridges", f.secondary_ridges, Whole{0, kMostFeatures});
    t.table("secondary_cost", f.secondary_cost);

    check_edge_weights(t, f.mean_edge_weight, f.edge_weight_deviation);
    t.check(o.solver != Solver::kFeatures || o.images.size() == 1, {"image"},
            fmt::format("the features solver shows exactly one image, found {}",
                        o.images.size()));
}

}  // namespace cydonia::config
