#include "synth/texture/constraints/sites.h"

#include <fmt/core.h>

#include <map>
#include <unordered_map>

#include "field/error.h"

namespace cydonia::texture {

using namespace geometry;

namespace {

using Site = Geometry::Site;

// Which part of the line from a to b is inside the box, as shares of the line (Liang and
// Barsky 1984); first > second: no part.
std::pair<double, double> clipped(const Point2& a, const Point2& b, const Box& box) {
    double from = 0.0, to = 1.0;
    const double low[2] = {box.west, box.south}, high[2] = {box.east, box.north};
    for (int axis = 0; axis < 2; ++axis) {
        const double d = b[axis] - a[axis];
        if (d == 0.0 && (a[axis] < low[axis] || a[axis] > high[axis])) return {1.0, 0.0};
        if (d == 0.0) continue;
        const double p = (low[axis] - a[axis]) / d, q = (high[axis] - a[axis]) / d;
        from = std::max(from, std::min(p, q));
        to = std::min(to, std::max(p, q));
    }
    return {from, to};
}

// Appends the sites of a curve, at multiples of one step. Returns whether any part of the
// curve is on the land.
bool add_sites(const CurveConstraint& curve, int owner, const Ground& ground,
               std::vector<Site>& sites) {
    const Box land{0.0, ground.width, 0.0, ground.depth};
    const Shape& shape = curve.shape;
    const double count = std::max(1.0, std::ceil(shape.length() / ground.spacing));
    const double step = shape.length() / count;
    bool inside = false;
    double next = 0.0;  // number of the next site
    for (int s = 0; s < shape.segments(); ++s) {
        const auto [from, to] = clipped(shape.points[s], shape.points[s + 1], land);
        if (from > to) continue;
        inside = true;
        const double begin = shape.along[s], length = shape.along[s + 1] - begin;
        next = std::max(next, std::ceil((begin + from * length) / step));
        const bool last = s + 1 == shape.segments() && to == 1.0;
        const double end = last ? count : std::floor((begin + to * length) / step);
        if (end - next + double(sites.size()) > double(kMostSites))
            throw bad_request("the curves are more than {} cells long: take away some",
                              kMostSites);
        for (; next <= end && !(shape.closed && next == count); ++next) {
            const Trait trait = curve.course.at(next * step);
            if (!(std::max(trait.area[0], trait.area[1]) > 0.0))
                continue;  // asks nothing
            const Point2 p = shape.at(next * step);
            if (land.holds(p)) sites.push_back({p[0], p[1], trait.height, owner});
        }
    }
    return inside;
}

struct Clash {
    int winner, loser;
    double apart = 0.0;  // metres of height
    int sites = 0;
};

// Two curves that cross at a small angle share a few cells; join() has warned of them.
constexpr int kAtCrossing = 4;

// Removes sites in cells that hold an earlier constraint's site of another height.
std::vector<Clash> resolve(std::vector<Site>& sites, double cell) {
    std::unordered_map<std::uint64_t, std::size_t>
        owners;  // the site that each cell holds
    std::map<std::pair<int, int>, Clash> clashes;
    std::vector<Site> kept;
    for (const Site& site : sites) {
        const auto key =
            std::uint64_t(site.y / cell) << 32 | std::uint64_t(site.x / cell);
        const auto [at, is_new] = owners.try_emplace(key, kept.size());
        const Site& earlier = is_new ? site : kept[at->second];
        const double apart = std::abs(site.height - earlier.height);
        if (earlier.constraint != site.constraint && apart > cell) {
            Clash& clash = clashes[{earlier.constraint, site.constraint}];
            clash = {earlier.constraint, site.constraint, std::max(clash.apart, apart),
                     clash.sites + 1};
            continue;
        }
        kept.push_back(site);
    }
    sites = std::move(kept);
    std::vector<Clash> list;
    for (const auto& [pair, clash] : clashes)
        if (clash.sites > kAtCrossing) list.push_back(clash);
    return list;
}

}  // namespace

std::vector<Site> sites_of(const std::vector<PointConstraint>& points,
                           const std::vector<CurveConstraint>& curves,
                           const Ground& ground, Progress& progress) {
    const Box land{0.0, ground.width, 0.0, ground.depth};
    std::vector<Site> sites;
    std::vector<std::string> outside;
    int owner = 0;
    for (const PointConstraint& point : points) {
        const bool inside = land.holds(point.at);
        if (!inside) outside.push_back(point.name);
        if (inside && point.radius > 0.0)
            sites.push_back({point.at[0], point.at[1], point.height, owner});
        ++owner;
    }
    for (const CurveConstraint& curve : curves)
        if (!add_sites(curve, owner++, ground, sites)) outside.push_back(curve.name);
    for (const std::string& name : outside)
        progress.warn(
            fmt::format("'{}' lies outside the terrain, which is {:.0f} by {:.0f} m",
                        name, ground.width, ground.depth));

    const auto name = [&](int i) {
        const auto s = static_cast<std::size_t>(i);
        return s < points.size() ? points[s].name : curves[s - points.size()].name;
    };
    for (const Clash& clash : resolve(sites, ground.spacing))
        progress.warn(fmt::format(
            "'{}' passes within a cell of '{}' with heights up to {:.0f} m apart: '{}' "
            "comes first and wins",
            name(clash.loser), name(clash.winner), clash.apart, name(clash.winner)));
    return sites;
}

}  // namespace cydonia::texture
