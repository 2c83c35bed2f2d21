// B. Rusnell, "Distance-based terrain synthesis" (2009), sections 3.2.1 and 3.3.1.

#include "synth/distance/profile.h"

#include <cmath>
#include <string>

#include "field/error.h"
#include "field/random.h"
#include "synth/distance/curve.h"
#include "synth/distance/relief.h"

namespace cydonia::distance {
namespace {

constexpr int kMostLayers = 64;
constexpr Length kLongestDetail = thesis_units(16.0);

std::string name_of(const Profile& profile) {
    return profile.name.empty() ? "profile" : "profile " + profile.name;
}

void check(const Profile& profile) {
    const auto share = [&](const char* what, double value) {
        if (!(value >= 0.0 && value <= 1.0)) {
            throw bad_request("{}: {} is {}: it must be from 0 to 1", name_of(profile),
                              what, value);
        }
    };
    share("strata.hardness", profile.strata.hardness);
    share("detail", profile.detail);
    if (profile.strata.layers < 0 || profile.strata.layers > kMostLayers) {
        throw bad_request("{}: strata.layers is {}: it must be from 0 to {}",
                          name_of(profile), profile.strata.layers, kMostLayers);
    }
}

// The points with distance in metres from 0 and cost from 0 to sea level, strictly
// increasing. Of points with the same cost the first stays, which averages the slope over
// their run.
std::vector<CostPoint> cost_line(const std::vector<CurvePoint>& falling, double reach,
                                 double sea_level) {
    const CurvePoint top = falling.front(), foot = falling.back();
    std::vector<CostPoint> line;
    for (const CurvePoint& p : falling) {
        const double cost = sea_level * ((top.f - p.f) / (top.f - foot.f));
        if (!line.empty() && !(cost > line.back().cost)) continue;
        line.push_back({reach * ((p.x - top.x) / (foot.x - top.x)), cost});
    }
    return line;
}

// The rule of min{t_s}: slopes that are too flat are interpolated, linearly in cost, from
// the nearest ones that are steep enough.
std::vector<double> slopes_of(const std::vector<CostPoint>& line, double least) {
    const std::size_t n = line.size() - 1;
    std::vector<double> slopes(n), middles(n);
    for (std::size_t i = 0; i < n; ++i) {
        slopes[i] =
            (line[i + 1].cost - line[i].cost) / (line[i + 1].distance - line[i].distance);
        middles[i] = 0.5 * (line[i].cost + line[i + 1].cost);
    }
    const std::vector<double> drawn = slopes;
    for (std::size_t i = 0; i < n; ++i) {
        if (drawn[i] >= least) continue;
        std::size_t below = i, above = i;
        while (below > 0 && drawn[below] < least) --below;
        while (above + 1 < n && drawn[above] < least) ++above;
        if (drawn[below] < least) below = above;
        if (drawn[above] < least) above = below;
        if (drawn[above] < least) {
            slopes[i] = least;  // the whole profile is too flat
        } else if (above == below) {
            slopes[i] = drawn[above];
        } else {
            const double t =
                (middles[i] - middles[below]) / (middles[above] - middles[below]);
            slopes[i] = std::lerp(drawn[below], drawn[above], t);
        }
    }
    return slopes;
}

}  // namespace

Descent descent_of(const Profile& profile, double sea_level, double mean_edge_weight,
                   double minimum_scale, double width) {
    check(profile);
    const std::vector<CurvePoint> falling =
        falling_points_of(profile.curve, name_of(profile));
    // docs/papers.md, Rusnell 3: one pixel, or unit of x, is one cell of the thesis.
    const double units = falling.back().x - falling.front().x;
    const double reach = profile.reach.value_or(thesis_units(units)).in(width);
    if (!(reach > 0.0)) {
        throw bad_request("{}: reach is {} m: it must be above 0", name_of(profile),
                          reach);
    }
    std::vector<CostPoint> line = cost_line(falling, reach, sea_level);
    const std::vector<double> slopes = slopes_of(line, minimum_scale * mean_edge_weight);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        line[i + 1].distance =
            line[i].distance + (line[i + 1].cost - line[i].cost) / slopes[i];
    }
    if (profile.detail > 0.0) {
        line = with_detail(line, profile.detail, kLongestDetail.in(width),
                           key(profile.name.c_str()));
    }
    if (profile.strata.layers > 0 && profile.strata.hardness > 0.0) {
        line = with_strata(line, profile.strata);
    }
    return tabulated(line);
}

std::vector<Descent> descents_of(const Options& options, double sea_level, double width) {
    std::vector<Descent> descents;
    for (const Profile& profile : options.profiles) {
        descents.push_back(descent_of(profile, sea_level, options.mean_edge_weight,
                                      options.minimum_scale, width));
    }
    return descents;
}

}  // namespace cydonia::distance
