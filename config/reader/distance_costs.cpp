// The curves of a distance stage, and the rules for the costs of generators.

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "config/reader/distance.h"
#include "config/reader/names.h"
#include "config/reader/readers.h"

namespace cydonia::config {

using distance::CostRule;
using distance::Curve;
using distance::Profile;
using Kind = CostRule::Kind;

namespace {

constexpr Name<Kind> kKinds[] = {
    {"noise", Kind::kNoise},       {"random", Kind::kRandom},
    {"painted", Kind::kPainted},   {"drawn", Kind::kDrawn},
    {"gaussian", Kind::kGaussian}, {"distance", Kind::kDistance},
    {"terrain", Kind::kTerrain},   {"minimum", Kind::kMinimum},
    {"sum", Kind::kSum},
};

constexpr std::size_t kMostRules = 8;

void read_curve(Table& t, Curve& curve) {
    t.field("image", curve.image, File{});
    t.field("table", curve.table, File{});
    t.field("points", curve.points, Number{});
}

bool east_of(const std::array<double, 2>& b, const std::array<double, 2>& a) {
    return b[0] > a[0];
}

int given(const Curve& curve) {
    return curve.image.has_value() + curve.table.has_value() + !curve.points.empty();
}

void check_points(Table& t, const Curve& curve) {
    t.check(curve.points.size() != 1, {"points"}, "needs at least two points");
}

// A profile may be one that ships, with a reach, strata or detail of its own.
void read_shipped_curve(Table& t, Curve& curve) {
    static const std::vector<std::string> kNone;
    std::string like;
    t.field("like", like, ProfileName{kNone});
    t.check(given(curve) + !like.empty() == 1, {"like", "image", "table", "points"},
            "needs exactly one of like, image, table and points");
    check_points(t, curve);
    if (!like.empty()) curve.table = t.shipped("like.table", shipped_profile(like));
}

// Whether `rule(next, point)` holds for all pairs of consecutive points.
template <class Rule>
bool all_pairs(const std::vector<std::array<double, 2>>& points, Rule rule) {
    return std::ranges::adjacent_find(points, [&](const auto& a, const auto& b) {
               return !rule(b, a);
           }) == points.end();
}

// The least and greatest costs, as lengths or as shares of a reference.
void read_bounds(Table& t, CostRule& cost, const Names& names, Sign sign) {
    const Range range = sign == Sign::kAny ? any() : at_least(0.0);
    t.field("range", cost.range, LengthUnit{range});
    t.field("share", cost.share, Number{range});
    t.field("share_of", cost.share_of,
            GroupName{names.groups, " before this one", "approximate"});
    t.field("less", cost.less, LengthUnit{at_least(0.0)});
    t.check(!cost.range || !cost.share, {"share", "range"},
            "give a range or a share, not both");
    t.only_if(cost.share.has_value(), {"share_of", "less"}, "a cost with a share");
}

void check_kind(Table& t, const CostRule& cost) {
    const bool painted = cost.kind == Kind::kPainted, drawn = cost.kind == Kind::kDrawn;
    const bool of = cost.kind == Kind::kMinimum || cost.kind == Kind::kSum;
    t.only_if(cost.kind == Kind::kNoise, {"noise"}, "kind = \"noise\"");
    t.only_if(painted || drawn, {"image"}, "kind = \"painted\" or \"drawn\"");
    t.only_if(drawn, {"table", "points"}, "kind = \"drawn\"");
    t.only_if(cost.kind == Kind::kDistance, {"centre"}, "kind = \"distance\"");
    t.only_if(cost.kind == Kind::kGaussian, {"azimuth"}, "kind = \"gaussian\"");
    t.only_if(of, {"of"}, "kind = \"minimum\" or \"sum\"");
    t.check(!of || cost.of.size() >= 2, {"of", "kind"},
            fmt::format("a {} needs 2 to {} rules in 'of'",
                        one_of(kKinds).text(cost.kind), kMostRules));
}

}  // namespace

void read(Table& t, Profile::Strata& strata) {
    t.field("layers", strata.layers, Whole{0, 64});
    t.field("hardness", strata.hardness, Number{from(0.0, 1.0)});
    t.only_if(strata.layers > 0, {"hardness"}, "strata with layers");
}

void read(Table& t, Profile& profile) {
    t.required("name", profile.name, Word{});
    read_curve(t, profile.curve);
    read_shipped_curve(t, profile.curve);
    t.field("reach", profile.reach, LengthUnit{above(0.0)});
    t.table("strata", profile.strata);
    t.field("detail", profile.detail, Number{from(0.0, 1.0)});
    const auto falls = [](const auto& b, const auto& a) {
        return east_of(b, a) && b[1] <= a[1];
    };
    t.check(all_pairs(profile.curve.points, falls), {"points"},
            "x must rise and f(x) must not rise from one point to the next");
}

void read(Table& t, CostRule& cost, const Names& names, const Sign& sign) {
    t.field("kind", cost.kind, one_of(kKinds));
    t.table("noise", cost.noise);
    read_curve(t, cost.curve);
    t.field("centre", cost.centre, LengthUnit{});
    t.field("azimuth", cost.azimuth, kAzimuth);
    const Sign of_terms = cost.kind == Kind::kSum || t.describes() ? Sign::kAny : sign;
    t.tables("of", cost.of, kMostRules, names, of_terms);
    t.field("inverted", cost.inverted, Flag{});
    read_bounds(t, cost, names, sign);
    check_kind(t, cost);
    if (cost.kind == Kind::kDrawn) {
        t.check(given(cost.curve) == 1, {"image", "table", "points"},
                "needs exactly one of image, table and points");
        check_points(t, cost.curve);
        t.check(all_pairs(cost.curve.points, east_of), {"points"},
                "x must rise from one point to the next");
    } else {
        cost.image = std::exchange(cost.curve.image, std::nullopt);
        t.check(cost.kind != Kind::kPainted || cost.image, {"image", "kind"},
                "a painted cost needs an image");
    }
}

}  // namespace cydonia::config
