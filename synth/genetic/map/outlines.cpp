#include "synth/genetic/map/outlines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "field/error.h"
#include "field/parallel.h"
#include "field/random.h"
#include "synth/genetic/map/segment_grid.h"

namespace cydonia::genetic {
namespace {

constexpr double kSame =
    1e-6;  // share of the terrain's larger side: nearer corners are one
constexpr double kFlat =
    1e-9;  // least area of an outline, as a share of its sides' squares
constexpr double kFarthest = 1e9;  // of a corner, in larger sides of the terrain
constexpr double kUnseen = 0.1;    // share of a cell: smaller bends are invisible
// The share of the room to its neighbours that a boundary may use.
constexpr double kClear = 0.45;

double distance(const Point2& a, const Point2& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1]);
}

double distance_to(const Point2& p, const Point2& a, const Point2& b) {
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double t = std::clamp(
        ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return distance(p, {a[0] + t * dx, a[1] + t * dy});
}

// All corners of a map. Corners at the same position are one.
class Corners {
  public:
    explicit Corners(double same) : same_(same) {}

    int index(const Point2& p) {
        const auto low = cell_of({p[0] - same_, p[1] - same_}),
                   high = cell_of({p[0] + same_, p[1] + same_});
        for (std::int64_t y = low.second; y <= high.second; ++y)
            for (std::int64_t x = low.first; x <= high.first; ++x) {
                const auto found = cells_.find({x, y});
                if (found == cells_.end()) continue;
                for (const int i : found->second)
                    if (distance(points_[std::size_t(i)], p) <= same_) return i;
            }
        cells_[cell_of(p)].push_back(int(points_.size()));
        points_.push_back(p);
        return int(points_.size()) - 1;
    }
    const Point2& operator[](int i) const { return points_[std::size_t(i)]; }
    // The corners sorted along an axis, for searches.
    std::vector<int> in_order(std::size_t axis) const {
        std::vector<int> order(points_.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = int(i);
        std::ranges::sort(order, {},
                          [&](int i) { return points_[std::size_t(i)][axis]; });
        return order;
    }

  private:
    std::pair<std::int64_t, std::int64_t> cell_of(const Point2& p) const {
        // Cells are so large that one of them nearly always holds everything nearby.
        return {std::int64_t(std::floor(p[0] / (16.0 * same_))),
                std::int64_t(std::floor(p[1] / (16.0 * same_)))};
    }
    double same_;
    std::vector<Point2> points_;
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<int>> cells_;
};

using Loop = std::vector<int>;     // corners
using Edge = std::pair<int, int>;  // the lower corner first

Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

// Adds to a loop the corners of other loops that lie on its edges.
Loop with_corners_on(const Loop& loop, const Corners& corners,
                     const std::array<std::vector<int>, 2>& orders, double same) {
    Loop result;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const int from = loop[i], to = loop[(i + 1) % loop.size()];
        const Point2 &a = corners[from], &b = corners[to];
        std::vector<std::pair<double, int>> between;
        // Searches along the axis on which fewer corners are in range.
        const auto near = [&](std::size_t axis) {
            const auto place = [&](int corner) { return corners[corner][axis]; };
            return std::ranges::subrange(
                std::ranges::lower_bound(orders[axis], std::min(a[axis], b[axis]) - same,
                                         {}, place),
                std::ranges::upper_bound(orders[axis], std::max(a[axis], b[axis]) + same,
                                         {}, place));
        };
        const auto x = near(0), y = near(1);
        for (const int k : x.size() < y.size() ? x : y)
            if (k != from && k != to && distance_to(corners[k], a, b) <= same)
                between.emplace_back(distance(a, corners[k]), k);
        std::ranges::sort(between);
        result.push_back(from);
        for (const auto& entry : between) result.push_back(entry.second);
    }
    return result;
}

void refuse_bad(const Loop& loop, const Corners& corners, const std::string& name) {
    if (loop.size() < 3)
        throw bad_request(
            "region '{}' has an outline of {} corners; at least 3 are needed", name,
            loop.size());
    std::vector<Point2> line;
    double area = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point2 &a = corners[loop[i]], &b = corners[loop[(i + 1) % loop.size()]];
        // Relative to its first corner, so that nothing is lost by rounding far from the
        // window.
        const Point2& o = corners[loop[0]];
        area += (a[0] - o[0]) * (b[1] - o[1]) - (b[0] - o[0]) * (a[1] - o[1]);
        squares += (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
        line.push_back(a);
    }
    line.push_back(line.front());
    if (const auto place = crossing_of(line))
        throw bad_request(
            "region '{}' crosses itself near {:.4g} m east, {:.4g} m north; draw it as "
            "outlines that do not",
            name, (*place)[0], (*place)[1]);
    if (std::abs(area) <= kFlat * squares)
        throw bad_request("region '{}' has an outline that encloses nothing", name);
}

struct Sides {
    std::vector<int> regions;  // on either side of the edge
};

double smoothness_of(const Sides& sides, const MapOptions& map,
                     const LibraryOptions& library) {
    if (sides.regions.size() == 2) {
        const std::string &a = map.regions[std::size_t(sides.regions[0])].type,
                          &b = map.regions[std::size_t(sides.regions[1])].type;
        for (const Seam& seam : library.seams)
            if ((seam.a == a && seam.b == b) || (seam.a == b && seam.b == a))
                return seam.smoothness;
    }
    return map.smoothness;
}

// Neighbours of the same type form one region, without a boundary.
bool is_within(const Sides& sides, const MapOptions& map) {
    return sides.regions.size() > 1 && std::ranges::all_of(sides.regions, [&](int r) {
               return map.regions[std::size_t(r)].type ==
                      map.regions[std::size_t(sides.regions.front())].type;
           });
}

// The map's edges, and what lies around them.
class Mesh {
  public:
    Mesh(const MapOptions& map, const Extent& extent);

    std::vector<Drawn> refined(const MapOptions& map, const LibraryOptions& library,
                               std::uint64_t seed) const;
    std::vector<Drawn> straight() const;

  private:
    bool on_frame(const Edge& edge) const;
    double clearance(const Edge& edge, double least, double most) const;
    double free_angle(const Edge& edge, int corner) const;
    double course(const Edge& edge, int corner) const;
    std::vector<Point2> line_of(const Edge& edge, const Sides& sides,
                                const MapOptions& map, const LibraryOptions& library,
                                std::uint64_t seed) const;

    Extent extent_;
    double same_;
    Corners corners_;
    std::vector<std::vector<Loop>> loops_;  // of each region
    std::map<Edge, Sides> edges_;
    std::map<int, std::vector<int>> neighbours_;  // corners along edges
    std::vector<Edge> in_grid_;
    std::optional<SegmentGrid> grid_;
};

Mesh::Mesh(const MapOptions& map, const Extent& extent)
    : extent_(extent),
      same_(kSame * std::max(extent.width(), extent.depth())),
      corners_(same_) {
    const auto [west, south, east, north] = map.window;
    std::vector<std::vector<Loop>> raw;
    for (const MapRegion& region : map.regions) {
        raw.emplace_back();
        if (region.outlines.empty())
            throw bad_request("region '{}' has no outline", region.name);
        for (const Outline& outline : region.outlines) {
            Loop loop;
            for (const auto& [x, y] : outline) {
                const Point2 at{(x - west) / (east - west) * extent.width(),
                                (y - south) / (north - south) * extent.depth()};
                if (!(std::max(std::abs(at[0]), std::abs(at[1])) <
                      kFarthest / kSame * same_))
                    throw bad_request(
                        "region '{}' reaches {:g} windows beyond the window; make the "
                        "window larger",
                        region.name, kFarthest);
                const int corner = corners_.index(at);
                if (loop.empty() || loop.back() != corner) loop.push_back(corner);
            }
            while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
            refuse_bad(loop, corners_, region.name);
            raw.back().push_back(std::move(loop));
        }
    }
    const std::array orders = {corners_.in_order(0), corners_.in_order(1)};
    for (std::size_t r = 0; r < raw.size(); ++r) {
        loops_.emplace_back();
        for (const Loop& loop : raw[r]) {
            loops_.back().push_back(with_corners_on(loop, corners_, orders, same_));
            const Loop& own = loops_.back().back();
            for (std::size_t i = 0; i < own.size(); ++i) {
                const int a = own[i], b = own[(i + 1) % own.size()];
                auto& sides = edges_[edge_of(a, b)];
                if (sides.regions.empty())
                    neighbours_[a].push_back(b), neighbours_[b].push_back(a);
                sides.regions.push_back(int(r));
            }
        }
    }
    if (!map.refine) return;
    std::vector<SegmentGrid::Segment> segments;
    for (const auto& entry : edges_) {
        in_grid_.push_back(entry.first);
        segments.emplace_back(corners_[entry.first.first], corners_[entry.first.second]);
    }
    // Anything farther away has no influence.
    const double w = extent.width(), d = extent.depth();
    grid_.emplace(std::move(segments), std::array{-w, -d, 2.0 * w, 2.0 * d});
}

bool Mesh::on_frame(const Edge& edge) const {
    const Point2 &a = corners_[edge.first], &b = corners_[edge.second];
    const auto beyond = [&](auto&& side) { return side(a) && side(b); };
    const double w = extent_.width(), d = extent_.depth(), s = same_;
    return beyond([&](const Point2& p) { return p[0] <= s; }) ||
           beyond([&](const Point2& p) { return p[0] >= w - s; }) ||
           beyond([&](const Point2& p) { return p[1] <= s; }) ||
           beyond([&](const Point2& p) { return p[1] >= d - s; });
}

// The distance to the nearest edge without a common corner: `most` if none is nearer, and
// any value below `least` if one is nearer than that. The search radius grows step by
// step.
double Mesh::clearance(const Edge& edge, double least, double most) const {
    const Point2 &a = corners_[edge.first], &b = corners_[edge.second];
    for (double reach = std::min(least, most);; reach = std::min(4.0 * reach, most)) {
        const std::array<double, 4> around = {
            std::min(a[0], b[0]) - reach, std::min(a[1], b[1]) - reach,
            std::max(a[0], b[0]) + reach, std::max(a[1], b[1]) + reach};
        double nearest = most;
        grid_->near(around, [&](std::size_t i) {
            const Edge& other = in_grid_[i];
            if (other.first != edge.first && other.first != edge.second &&
                other.second != edge.first && other.second != edge.second) {
                const auto& [c, d] = (*grid_)[i];
                nearest = std::min({nearest, distance_to(a, c, d), distance_to(b, c, d),
                                    distance_to(c, a, b), distance_to(d, a, b)});
            }
            return nearest >= least;
        });
        if (nearest <= reach || reach >= most) return nearest;
    }
}

double angle_of(const Point2& from, const Point2& to) {
    return std::atan2(to[1] - from[1], to[0] - from[0]);
}

// The angle to the nearest other edge at a corner.
double Mesh::free_angle(const Edge& edge, int corner) const {
    const int far = edge.first == corner ? edge.second : edge.first;
    const double own = angle_of(corners_[corner], corners_[far]);
    double least = std::numbers::pi;
    for (const int other : neighbours_.at(corner))
        if (other != far)
            least = std::min(least, std::abs(std::remainder(
                                        angle_of(corners_[corner], corners_[other]) - own,
                                        2.0 * std::numbers::pi)));
    return least;
}

// Where exactly two edges meet they continue each other; each takes half of the bend.
double Mesh::course(const Edge& edge, int corner) const {
    const auto& around = neighbours_.at(corner);
    if (around.size() != 2) return 0.0;
    const bool begins = edge.first == corner;
    const int far = begins ? edge.second : edge.first,
              other = around[0] == far ? around[1] : around[0];
    const double own = begins ? angle_of(corners_[corner], corners_[far])
                              : angle_of(corners_[far], corners_[corner]);
    const double on = begins ? angle_of(corners_[other], corners_[corner])
                             : angle_of(corners_[corner], corners_[other]);
    return 0.5 * std::remainder(on - own, 2.0 * std::numbers::pi);
}

std::vector<Drawn> Mesh::straight() const {
    std::vector<Drawn> result;
    for (const auto& loops : loops_) {
        result.emplace_back();
        for (const Loop& loop : loops) {
            auto& outline = result.back().outlines.emplace_back();
            for (const int corner : loop) outline.push_back(corners_[corner]);
        }
    }
    return result;
}

std::vector<Point2> Mesh::line_of(const Edge& edge, const Sides& sides,
                                  const MapOptions& map, const LibraryOptions& library,
                                  std::uint64_t seed) const {
    const auto [first, second] = edge;
    const Point2 &a = corners_[first], &b = corners_[second];
    const double length = distance(a, b);
    if (length <= extent_.spacing || on_frame(edge) || is_within(sides, map))
        return {a, b};
    const double drawn = map.envelope > 0.0 ? map.envelope : 0.2 * length;
    const double unseen = kUnseen * extent_.spacing;
    const double envelope =
        kClear * clearance(edge, unseen / kClear, std::min(drawn, 0.3 * length) / kClear);
    if (envelope < unseen) return {a, b};
    const StraightBoundary boundary{
        .from = a,
        .to = b,
        .smoothness = smoothness_of(sides, map, library),
        .envelope = envelope,
        .free_at = {free_angle(edge, first), free_angle(edge, second)},
        .course = {course(edge, first), course(edge, second)},
        .segment = extent_.spacing,
        .window = {0.0, 0.0, extent_.width(), extent_.depth()}};
    // The seed depends on the edge's position, so that changes elsewhere do not affect
    // it.
    const auto bits = [](double v) { return std::uint64_t(std::llround(v * 1000.0)); };
    return genetic::refined(
        boundary, hash_of({seed, bits(a[0]), bits(a[1]), bits(b[0]), bits(b[1])}));
}

std::vector<Drawn> Mesh::refined(const MapOptions& map, const LibraryOptions& library,
                                 std::uint64_t seed) const {
    struct Task {
        Edge edge;
        const Sides* sides;
        std::vector<Point2> line;
    };
    std::vector<Task> tasks;
    std::map<Edge, std::size_t> task_of;
    for (const auto& [edge, sides] : edges_) {
        task_of[edge] = tasks.size();
        tasks.push_back({edge, &sides, {}});
    }
    parallel_for(int(tasks.size()), [&](int i) {
        Task& task = tasks[std::size_t(i)];
        task.line = line_of(task.edge, *task.sides, map, library, seed);
    });
    std::vector<Drawn> result;
    for (const auto& loops : loops_) {
        result.emplace_back();
        for (const Loop& loop : loops) {
            auto& outline = result.back().outlines.emplace_back();
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int from = loop[i], to = loop[(i + 1) % loop.size()];
                const auto& line = tasks[task_of.at(edge_of(from, to))].line;
                if (from < to)
                    outline.insert(outline.end(), line.begin(), line.end() - 1);
                else
                    outline.insert(outline.end(), line.rbegin(), line.rend() - 1);
            }
        }
    }
    return result;
}

}  // namespace

std::vector<Drawn> drawn_outlines(const MapOptions& map, const LibraryOptions& library,
                                  const Extent& extent, std::uint64_t seed) {
    const Mesh mesh(map, extent);
    return map.refine ? mesh.refined(map, library, seed) : mesh.straight();
}

}  // namespace cydonia::genetic
