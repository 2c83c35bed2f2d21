#include "synth/texture/constraints/junctions.h"

#include <fmt/core.h>

#include <map>

#include "synth/texture/constraints/crossings.h"

namespace cydonia::texture {

using namespace geometry;

namespace {

// A place where two constraints ask for different heights.
struct Dispute {
    Point2 at{};
    double won = 0.0, lost = 0.0;  // heights where they differ most, metres
    int places = 0;
};

// The knots moved into [0, length), without two at the same position.
std::vector<Knot> onto_ring(std::vector<Knot> knots, double length) {
    for (Knot& knot : knots) {
        if (knot.at < 0.0) knot.at += length;
        if (knot.at >= length) knot.at -= length;
    }
    std::sort(knots.begin(), knots.end(),
              [](const Knot& a, const Knot& b) { return a.at < b.at; });
    knots.erase(
        std::unique(knots.begin(), knots.end(),
                    [](const Knot& a, const Knot& b) { return b.at - a.at < 1e-6; }),
        knots.end());
    return knots;
}

class Joiner {
  public:
    Joiner(std::vector<PointConstraint>& points, std::vector<CurveConstraint>& curves,
           const Ground& ground)
        : points_(points),
          curves_(curves),
          land_{0.0, ground.width, 0.0, ground.depth},
          cell_(ground.spacing) {}

    void join() {
        const auto crossings = crossings_of(points_, curves_, cell_);
        // In the order of the constraints, so that the earlier of two is settled already.
        for (auto begin = crossings.begin(); begin != crossings.end();) {
            auto end = begin;
            while (end != crossings.end() && end->second == begin->second) ++end;
            settle({begin, end});
            begin = end;
        }
    }

    void warn(Progress& progress) const {
        for (const auto& [pair, d] : disputes_) {
            const auto& [first, second] = pair;
            const std::string more =
                d.places > 1
                    ? fmt::format(" (the largest difference of {} places)", d.places)
                    : "";
            if (first == second)
                progress.warn(
                    fmt::format("'{}' crosses itself at ({:.0f}, {:.0f}) m with heights "
                                "of {:.0f} m and "
                                "{:.0f} m{}: their mean is taken",
                                name(first), d.at[0], d.at[1], d.won, d.lost, more));
            else
                progress.warn(
                    fmt::format("'{}' meets '{}' at ({:.0f}, {:.0f}) m with a height of "
                                "{:.0f} m, not "
                                "{:.0f} m{}: '{}' comes first and wins",
                                name(second), name(first), d.at[0], d.at[1], d.lost,
                                d.won, more, name(first)));
        }
    }

  private:
    bool is_point(int owner) const { return std::size_t(owner) < points_.size(); }
    CurveConstraint& curve(int owner) const {
        return curves_[std::size_t(owner) - points_.size()];
    }
    const std::string& name(int owner) const {
        return is_point(owner) ? points_[owner].name : curve(owner).name;
    }
    double height(int owner, double along) const {
        return is_point(owner) ? points_[owner].height
                               : curve(owner).course.height(along);
    }

    void note(const Crossing& m, double won, double lost) {
        if (std::abs(won - lost) <= 0.1 * cell_ || !land_.holds(m.at)) return;
        Dispute& dispute = disputes_[{m.first, m.second}];
        ++dispute.places;
        if (dispute.places > 1 &&
            std::abs(won - lost) <= std::abs(dispute.won - dispute.lost))
            return;
        dispute.at = m.at;
        dispute.won = won;
        dispute.lost = lost;
    }

    // Settles all crossings of one constraint with earlier ones.
    void settle(const std::vector<Crossing>& crossings) {
        const int owner = crossings.front().second;
        std::vector<Knot> heights;
        for (const Crossing& m : crossings) {
            if (m.first == m.second) continue;
            const double won = height(m.first, m.along[0]);
            if (add(heights, m.along[1], won)) note(m, won, height(owner, m.along[1]));
        }
        if (is_point(owner)) {
            points_[owner].height = heights.front().value;
            return;
        }
        for (const Crossing& m : crossings)
            if (m.first == m.second) tie(heights, m);
        bend(curve(owner), std::move(heights));
    }

    // The knot within a cell of `along`, if there is one: it decides the height there.
    const Knot* standing(const std::vector<Knot>& heights, double along) const {
        for (const Knot& knot : heights)
            if (std::abs(knot.at - along) < cell_) return &knot;
        return nullptr;
    }
    bool add(std::vector<Knot>& heights, double along, double height) const {
        if (standing(heights, along)) return false;
        heights.push_back({along, height});
        return true;
    }

    // Gives one height to a crossing of a curve with itself.
    void tie(std::vector<Knot>& heights, const Crossing& m) {
        const double a = height(m.second, m.along[0]), b = height(m.second, m.along[1]);
        const Knot* held = standing(heights, m.along[0]);
        if (!held) held = standing(heights, m.along[1]);
        const double common = held ? held->value : 0.5 * (a + b);
        if (!held) note(m, a, b);
        add(heights, m.along[0], common);
        add(heights, m.along[1], common);
    }

    // How far along a curve it is bent on either side of a junction, metres.
    double bent_over(const Trait& trait, double by) const {
        return std::max({2.0 * std::max(trait.area[0], trait.area[1]), 2.0 * std::abs(by),
                         4.0 * cell_});
    }

    // The distance from a junction to where a curve has its own height again, metres; 0
    // where there is no room for that. A free end keeps its height where there is room
    // for half the bend.
    static double room(double reach, double gap, bool to_free_end) {
        if (reach < gap) return reach;
        return to_free_end && 2.0 * gap > reach ? gap : 0.0;
    }

    // Adds to the curve what its heights at junctions lack, and nothing at its handles
    // and farther away.
    void bend(CurveConstraint& curve, std::vector<Knot> heights) const {
        const Course& course = curve.course;
        const double length = curve.shape.length();
        std::vector<Knot> added;
        for (const Knot& knot : heights)
            added.push_back({knot.at, knot.value - course.height(knot.at)});
        for (double held : course.held())
            if (!standing(heights, held)) added.push_back({held, 0.0});
        std::sort(added.begin(), added.end(),
                  [](const Knot& a, const Knot& b) { return a.at < b.at; });

        const bool ring = curve.shape.closed;
        const double begin = ring ? added.back().at - length : 0.0;
        const double end = ring ? added.front().at + length : length;
        std::vector<Knot> knots;
        for (std::size_t i = 0; i < added.size(); ++i) {
            const Knot& knot = added[i];
            const bool first = i == 0, last = i + 1 == added.size();
            const double reach = bent_over(course.at(knot.at), knot.value);
            const double before =
                room(reach, knot.at - (first ? begin : added[i - 1].at), first && !ring);
            const double after =
                room(reach, (last ? end : added[i + 1].at) - knot.at, last && !ring);
            // The curve is level between two junctions only where both bends have ended.
            if (before > 0.0 && (knots.empty() || knot.at - before > knots.back().at))
                knots.push_back({knot.at - before, 0.0});
            knots.push_back(knot);
            if (after > 0.0) knots.push_back({knot.at + after, 0.0});
        }
        if (ring) knots = onto_ring(std::move(knots), length);
        curve.course.bend(knots);
    }

    std::vector<PointConstraint>& points_;
    std::vector<CurveConstraint>& curves_;
    Box land_;
    double cell_;
    std::map<std::pair<int, int>, Dispute> disputes_;
};

}  // namespace

void join(std::vector<PointConstraint>& points, std::vector<CurveConstraint>& curves,
          const Ground& ground, Progress& progress) {
    Joiner joiner(points, curves, ground);
    joiner.join();
    joiner.warn(progress);
}

}  // namespace cydonia::texture
