#include <fmt/format.h>

#include <algorithm>

#include "config/reader/readers.h"

namespace cydonia::config {

using distance::CostRule;
using distance::Options;
using distance::PeakOptions;
using distance::Profile;
using distance::RidgeOptions;

namespace {

constexpr Name<CostRule::Kind> kCostKinds[] = {
    {"noise", CostRule::Kind::kNoise},
    {"random", CostRule::Kind::kRandom},
};

constexpr Name<Options::Metric> kMetrics[] = {
    {"euclidean", Options::Metric::kEuclidean},
    {"thesis", Options::Metric::kThesis},
};

constexpr int kMostFeatures = 1000000;

bool falls(const std::vector<std::array<double, 2>>& points) {
    return std::ranges::adjacent_find(points, [](const auto& a, const auto& b) {
               return b[0] <= a[0] || b[1] > a[1];
           }) == points.end();
}

bool rises(const std::array<Length, 2>& range) {
    const auto [least, most] = range;
    const bool same_unit = (least.metres == 0.0 && most.metres == 0.0) ||
                           (least.fraction == 0.0 && most.fraction == 0.0);
    return same_unit && least.metres <= most.metres && least.fraction <= most.fraction;
}

}  // namespace

void read(Table& t, CostRule& cost) {
    t.field("kind", cost.kind, one_of(kCostKinds));
    t.table("noise", cost.noise);
    t.field("range", cost.range, LengthUnit{at_least(0.0)});
    t.only_if(cost.kind == CostRule::Kind::kNoise, {"noise"}, "kind = \"noise\"");
    t.only_if(cost.kind == CostRule::Kind::kRandom, {"range"}, "kind = \"random\"");
    t.check(rises(cost.range), {"range"},
            "must go from least to most, both in metres or both as shares of the width");
}

void read(Table& t, PeakOptions& peaks) {
    t.field("count", peaks.count, Whole{0, kMostFeatures});
    t.table("cost", peaks.cost);
}

void read(Table& t, RidgeOptions& ridges) {
    t.field("count", ridges.count, Whole{0, kMostFeatures});
    t.field("cost_factor", ridges.cost_factor, Number{from(0.0, 1.0)});
}

void read(Table& t, Profile& profile) {
    t.field("image", profile.image, File{});
    t.field("points", profile.points, Number{});
    t.field("reach", profile.reach, LengthUnit{above(0.0)});
    t.check(!profile.image || profile.points.empty(), {"points", "image"},
            "give an image or points, not both");
    t.check(profile.points.size() != 1, {"points"}, "needs at least two points");
    t.check(falls(profile.points), {"points"},
            "x must rise and f(x) must not rise from one point to the next");
    t.only_if(!profile.empty(), {"reach"}, "a profile with an image or points");
}

void read(Table& t, Options& o) {
    t.field("strokes", o.strokes, File{});
    t.table("cost", o.cost);
    t.table("peaks", o.peaks);
    t.table("ridges", o.ridges);
    t.table("profile", o.profile);
    t.field("mean_edge_weight", o.mean_edge_weight, Number{above_to(0.0, 1000.0)});
    t.field("edge_weight_deviation", o.edge_weight_deviation, Number{from(0.0, 1000.0)});
    t.field("grain", o.grain, LengthUnit{above(0.0)});
    t.field("sea_level_scale", o.sea_level_scale, Number{above_to(0.0, 100.0)});
    t.field("blending_bias", o.blending_bias, Number{from(0.0, 100.0)});
    t.field("sea_level_threshold", o.sea_level_threshold, LengthUnit{at_least(0.0)});
    t.field("approximate_threshold", o.approximate_threshold, Number{from(0.0, 1.0)});
    t.field("minimum_scale", o.minimum_scale, Number{above_to(0.0, 1.0)});
    t.field("metric", o.metric, one_of(kMetrics));
    t.field("neighbours", o.neighbours, Whole{8, 16});

    t.check(o.neighbours == 8 || o.neighbours == 16, {"neighbours"}, "must be 8 or 16");
    check_edge_weights(t, o.mean_edge_weight, o.edge_weight_deviation);
    t.check(o.strokes || o.peaks.count > 0, {"strokes", "peaks"},
            "nothing to build from; give strokes or peaks.count");
}

}  // namespace cydonia::config
