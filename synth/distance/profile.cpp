// B. Rusnell, "Distance-based terrain synthesis" (2009), sections 3.2.1 and 3.3.1.

#include "synth/distance/profile.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "field/error.h"
#include "field/image.h"
#include "field/strokes.h"
#include "field/svg.h"

namespace cydonia::distance {
namespace {

constexpr int kTableSize = 4096;

struct Point {
    double x, y;
};

// A drawing has no pixels of its own.
constexpr int kSvgPixels = 512;

// The middle of the dark line in each column of a picture; columns without are bridged.
std::vector<Point> traced_line(const Source& source) {
    const Field<float> image =
        is_svg(source) ? read_grey_at(source, kSvgPixels, kSvgPixels) : read_grey(source);
    std::vector<Point> points;
    for (int x = 0; x < image.width(); ++x) {
        double sum = 0.0;
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            if (image(x, y) >= 0.5f) continue;
            sum += y;
            ++count;
        }
        if (count > 0) points.push_back({1.0 * x, -sum / count});
    }
    if (points.size() < 2) {
        throw bad_request(
            "profile {}: a dark line over at least two columns of a light picture is "
            "needed, {} found",
            source.name(), points.size());
    }
    return points;
}

// A drawn line may waver by a pixel; anything more is a rise.
void check_falling(std::vector<Point>& points, double tolerance, const std::string& name,
                   const char* unit_of_x) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (!(points[i].x > points[i - 1].x)) {
            throw bad_request("{}: x must increase, but {} follows {}", name, points[i].x,
                              points[i - 1].x);
        }
        if (!(points[i].y <= points[i - 1].y + tolerance)) {
            throw bad_request(
                "{} rises at x = {}{}: a cross-section must fall from the feature "
                "outward",
                name, points[i].x, unit_of_x);
        }
        points[i].y = std::min(points[i].y, points[i - 1].y);
    }
    if (points.size() < 2 || !(points.back().y < points.front().y)) {
        throw bad_request("{} is flat: it must fall from the feature outward", name);
    }
}

std::vector<Point> falling_line(const Profile& profile) {
    std::vector<Point> points;
    const Curve& curve = profile.curve;
    if (curve.image) {
        points = traced_line(*curve.image);
        check_falling(points, 1.0, "profile " + curve.image->path.string(), " pixels");
    } else {
        for (const auto& [x, y] : curve.points) points.push_back({x, y});
        check_falling(points, 0.0, "profile", "");
    }
    return points;
}

// x from 0 in metres, y the cost from 0 to sea level, strictly increasing: of points at
// the same cost the first stays, which averages the slope over their run.
std::vector<Point> cost_line(const std::vector<Point>& falling, double reach,
                             double sea_level) {
    const Point top = falling.front(), foot = falling.back();
    std::vector<Point> line;
    for (const Point& p : falling) {
        const double cost = sea_level * ((top.y - p.y) / (top.y - foot.y));
        if (!line.empty() && !(cost > line.back().y)) continue;
        line.push_back({reach * ((p.x - top.x) / (foot.x - top.x)), cost});
    }
    return line;
}

// The rule of min{t_s}: slopes too flat to leave are interpolated, linearly in cost, from
// the nearest steep enough ones.
std::vector<double> slopes_of(const std::vector<Point>& line, double least) {
    const std::size_t n = line.size() - 1;
    std::vector<double> slopes(n), middles(n);
    for (std::size_t i = 0; i < n; ++i) {
        slopes[i] = (line[i + 1].y - line[i].y) / (line[i + 1].x - line[i].x);
        middles[i] = 0.5 * (line[i].y + line[i + 1].y);
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
    const std::vector<Point> falling = falling_line(profile);
    // notes.md, Rusnell 3: one pixel, or unit of x, is one cell of the thesis.
    const double units = falling.back().x - falling.front().x;
    const double reach =
        profile.reach ? profile.reach->in(width) : thesis_units(units).in(width);
    if (!(reach > 0.0))
        throw bad_request("profile reach is {} m: it must be above 0", reach);
    std::vector<Point> line = cost_line(falling, reach, sea_level);
    const std::vector<double> slopes = slopes_of(line, minimum_scale * mean_edge_weight);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        line[i + 1].x = line[i].x + (line[i + 1].y - line[i].y) / slopes[i];
    }

    Descent descent;
    descent.sea_level = sea_level;
    descent.reach = line.back().x;
    descent.beyond = static_cast<float>(slopes.back());
    descent.per_metre = static_cast<float>((kTableSize - 1) / descent.reach);
    descent.costs.resize(kTableSize);
    std::size_t k = 0;
    for (int i = 0; i < kTableSize; ++i) {
        const double x = descent.reach * i / (kTableSize - 1);
        while (k + 2 < line.size() && line[k + 1].x < x) ++k;
        descent.costs[i] = static_cast<float>(line[k].y + slopes[k] * (x - line[k].x));
    }
    return descent;
}

std::vector<Descent> descents_of(const Options& options, double sea_level, double width) {
    std::vector<Descent> descents;
    for (const Profile& profile : options.profiles) {
        descents.push_back(descent_of(profile, sea_level, options.mean_edge_weight,
                                      options.minimum_scale, width));
    }
    return descents;
}

ProfileGrowth::ProfileGrowth(const Descent& descent, std::span<const Start> starts,
                             double mean_edge_weight)
    : descent_(&descent),
      starts_(starts),
      distance_(static_cast<float>(1.0 / mean_edge_weight)) {
    for (const Start& start : starts) {
        shares_.push_back(
            static_cast<float>((descent.sea_level - start.cost) / descent.sea_level));
    }
}

}  // namespace cydonia::distance
