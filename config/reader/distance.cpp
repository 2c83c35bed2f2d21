#include "config/reader/distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "config/reader/readers.h"

namespace cydonia::config {

using distance::Group;
using distance::Map;
using distance::Options;
using distance::Profile;
using distance::RegionOptions;
using distance::Water;

namespace {

constexpr Name<Options::Metric> kMetrics[] = {
    {"euclidean", Options::Metric::kEuclidean},
    {"thesis", Options::Metric::kThesis},
};

constexpr Name<Options::Combine> kCombines[] = {
    {"add", Options::Combine::kAdd},
    {"replace", Options::Combine::kReplace},
};

constexpr std::size_t kMostGroups = 64, kMostProfiles = 64, kMostRegions = 64,
                      kMostWaters = 64;
constexpr Range kWeights = above_to(0.0, 1000.0), kDeviations = from(0.0, 1000.0),
                kBiases = from(0.0, 100.0);

}  // namespace

void read(Table& t, Map& map, const Range& range) {
    t.required("image", map.image, File{});
    t.required("range", map.range, Number{range});
}

void read(Table& t, RegionOptions& region, const Names& names) {
    const GroupName group{names.groups, ""};
    t.field("image", region.image, File{});
    t.field("inside", region.inside, group);
    t.field("profile", region.profile, ProfileName{names.profiles});
    t.field("only", region.only, group);
    t.field("feather", region.feather, LengthUnit{at_least(0.0)});
    t.check(region.image.has_value() == region.inside.empty(), {"inside", "image"},
            "needs exactly one of image and inside");
    t.only_if(names.random_weights, {"profile"}, "a stage without edge_weights");
}

void read(Table& t, Water& water, const Names& names) {
    t.required("image", water.image, File{});
    t.field("level", water.level, LengthUnit{}, "auto");
    t.field("depth", water.depth, LengthUnit{above(0.0)});
    t.field("bed", water.bed, ProfileName{names.profiles});
    t.field("shore_slope", water.shore_slope, Number{kWeights});
}

namespace {

void read_weights(Table& t, Options& o) {
    t.field("mean_edge_weight", o.mean_edge_weight, Number{kWeights});
    t.table("mean_edge_weight_map", o.mean_edge_weight_map, kWeights);
    t.field("edge_weight_deviation", o.edge_weight_deviation, Number{kDeviations});
    t.table("edge_weight_deviation_map", o.edge_weight_deviation_map, kDeviations);
    t.table("edge_weights", o.edge_weights, kWeights);
    t.field("grain", o.grain, LengthUnit{above(0.0)});
    t.field("metric", o.metric, one_of(kMetrics));
    t.field("neighbours", o.neighbours, Whole{8, 16});

    t.only_if(!o.edge_weights,
              {"mean_edge_weight", "mean_edge_weight_map", "edge_weight_deviation",
               "edge_weight_deviation_map"},
              "a stage without edge_weights");
    t.only_if(!o.mean_edge_weight_map, {"mean_edge_weight"},
              "a stage without mean_edge_weight_map");
    t.only_if(!o.edge_weight_deviation_map, {"edge_weight_deviation"},
              "a stage without edge_weight_deviation_map");
    check_edge_weights(
        t,
        o.mean_edge_weight_map ? std::ranges::min(o.mean_edge_weight_map->range)
                               : o.mean_edge_weight,
        o.edge_weight_deviation_map ? std::ranges::max(o.edge_weight_deviation_map->range)
                                    : o.edge_weight_deviation);
    t.check(o.neighbours == 8 || o.neighbours == 16, {"neighbours"}, "must be 8 or 16");
    t.check(o.metric == Options::Metric::kEuclidean || o.neighbours == 8,
            {"neighbours", "metric"}, "metric = \"thesis\" has 8 neighbours");
}

void read_blending(Table& t, Options& o) {
    t.field("sea_level_scale", o.sea_level_scale, Number{above_to(0.0, 100.0)});
    t.field("blending_bias", o.blending_bias, Number{kBiases});
    t.table("blending_bias_map", o.blending_bias_map, kBiases);
    t.field("sea_level_threshold", o.sea_level_threshold, LengthUnit{at_least(0.0)});
    t.field("approximate_threshold", o.approximate_threshold,
            Number{Range{0.0, 1.0, true, false}});
    t.field("minimum_scale", o.minimum_scale, Number{above_to(0.0, 1.0)});
    t.only_if(!o.blending_bias_map, {"blending_bias"},
              "a stage without blending_bias_map");
}

void read_profiles(Table& t, Options& o, Names& names) {
    t.tables("profile", o.profiles, kMostProfiles);
    t.unique("profile", "name");
    for (const Profile& profile : o.profiles) names.profiles.push_back(profile.name);
    t.only_if(names.random_weights, {"profile"}, "a stage without edge_weights");
}

// The names of all profiles that are referred to, each once, in the file's order.
std::vector<std::string> wanted_profiles(const Options& o) {
    std::vector<std::string> wanted;
    const auto want = [&](const std::string& name) {
        if (!name.empty() && std::ranges::find(wanted, name) == wanted.end())
            wanted.push_back(name);
    };
    for (const Group& group : o.groups) {
        std::ranges::for_each(group.profile, want);
        want(group.other_side);
    }
    for (const RegionOptions& region : o.regions) want(region.profile);
    for (const Water& water : o.water) want(water.bed);
    return wanted;
}

// Adds the profiles that the stage does not have itself from the files that ship.
void add_shipped_profiles(Table& t, Options& o) {
    for (const std::string& name : wanted_profiles(o)) {
        if (std::ranges::find(o.profiles, name, &Profile::name) != o.profiles.end())
            continue;
        Profile profile;
        profile.name = name;
        profile.curve.table =
            t.shipped(fmt::format("profile.{}.table", name), shipped_profile(name));
        o.profiles.push_back(profile);
    }
}

}  // namespace

void read(Table& t, Options& o) {
    read_weights(t, o);
    read_blending(t, o);
    Names names;
    names.random_weights = !o.edge_weights;
    read_profiles(t, o, names);
    t.tables("group", o.groups, kMostGroups, names);
    t.tables("region", o.regions, kMostRegions, names);
    t.tables("water", o.water, kMostWaters, names);
    add_shipped_profiles(t, o);
    t.field("vertical_scale", o.vertical_scale, Number{kWeights});
    t.field("combine", o.combine, one_of(kCombines));
    t.field("preview", o.preview, Flag{});
    t.check(!o.groups.empty(), {"group"},
            "the stage has no features; add at least one [[terrain.stage.group]]");
}

}  // namespace cydonia::config
