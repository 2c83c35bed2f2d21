#include "synth/texture/constraints/junctions.h"

#include <fmt/core.h>

#include <map>

#include "synth/texture/constraints/meetings.h"

namespace cydonia::texture {
namespace {

// Where two constraints want different heights.
struct Dispute {
    Point2 at{};
    double won = 0.0, lost = 0.0;  // metres, where they differ most
    int places = 0;
};

// The same knots from 0 to length, none at one place.
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
    Joiner(std::vector<Spike>& spikes, std::vector<Strand>& strands, const Ground& ground)
        : spikes_(spikes),
          strands_(strands),
          land_{0.0, ground.width, 0.0, ground.depth},
          cell_(ground.spacing) {}

    void join() {
        const auto meetings = meetings_of(spikes_, strands_, cell_);
        // In their order, so that what comes earlier is settled.
        for (auto begin = meetings.begin(); begin != meetings.end();) {
            auto end = begin;
            while (end != meetings.end() && end->second == begin->second) ++end;
            settle({begin, end});
            begin = end;
        }
    }

    void warn(Progress& progress) const {
        for (const auto& [pair, d] : disputes_) {
            const auto& [first, second] = pair;
            const std::string more =
                d.places > 1 ? fmt::format(" (the most of {} places)", d.places) : "";
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
    bool is_spike(int owner) const { return std::size_t(owner) < spikes_.size(); }
    Strand& strand(int owner) const {
        return strands_[std::size_t(owner) - spikes_.size()];
    }
    const std::string& name(int owner) const {
        return is_spike(owner) ? spikes_[owner].name : strand(owner).name;
    }
    double height(int owner, double along) const {
        return is_spike(owner) ? spikes_[owner].height
                               : strand(owner).course.height(along);
    }

    void note(const Meeting& m, double won, double lost) {
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

    // All meetings of the later of two constraints.
    void settle(const std::vector<Meeting>& meetings) {
        const int owner = meetings.front().second;
        std::vector<Knot> heights;
        for (const Meeting& m : meetings) {
            if (m.first == m.second) continue;
            const double won = height(m.first, m.along[0]);
            if (add(heights, m.along[1], won)) note(m, won, height(owner, m.along[1]));
        }
        if (is_spike(owner)) {
            spikes_[owner].height = heights.front().value;
            return;
        }
        for (const Meeting& m : meetings)
            if (m.first == m.second) tie(heights, m);
        bend(strand(owner), std::move(heights));
    }

    // What stands there already holds.
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

    // A curve with itself.
    void tie(std::vector<Knot>& heights, const Meeting& m) {
        const double a = height(m.second, m.along[0]), b = height(m.second, m.along[1]);
        const Knot* held = standing(heights, m.along[0]);
        if (!held) held = standing(heights, m.along[1]);
        const double common = held ? held->value : 0.5 * (a + b);
        if (!held) note(m, a, b);
        add(heights, m.along[0], common);
        add(heights, m.along[1], common);
    }

    // Metres along a curve from a junction to where its bending ends.
    double bent_over(const Trait& trait, double by) const {
        return std::max({2.0 * std::max(trait.area[0], trait.area[1]), 2.0 * std::abs(by),
                         4.0 * cell_});
    }

    // Metres from a junction to where a curve is itself again, 0 where it has no room to
    // be. A free end stays as it is where there is room for half the bending.
    static double room(double reach, double gap, bool to_free_end) {
        if (reach < gap) return reach;
        return to_free_end && 2.0 * gap > reach ? gap : 0.0;
    }

    // Adds what is missing to the junctions' heights, and nothing at handles and farther
    // away.
    void bend(Strand& strand, std::vector<Knot> heights) const {
        const Course& course = strand.course;
        const double length = strand.shape.length();
        std::vector<Knot> added;
        for (const Knot& knot : heights)
            added.push_back({knot.at, knot.value - course.height(knot.at)});
        for (double held : course.held())
            if (!standing(heights, held)) added.push_back({held, 0.0});
        std::sort(added.begin(), added.end(),
                  [](const Knot& a, const Knot& b) { return a.at < b.at; });

        const bool ring = strand.shape.closed;
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
            // Level between two junctions only where both have ended.
            if (before > 0.0 && (knots.empty() || knot.at - before > knots.back().at))
                knots.push_back({knot.at - before, 0.0});
            knots.push_back(knot);
            if (after > 0.0) knots.push_back({knot.at + after, 0.0});
        }
        if (ring) knots = onto_ring(std::move(knots), length);
        strand.course.bend(knots);
    }

    std::vector<Spike>& spikes_;
    std::vector<Strand>& strands_;
    Box land_;
    double cell_;
    std::map<std::pair<int, int>, Dispute> disputes_;
};

}  // namespace

void join(std::vector<Spike>& spikes, std::vector<Strand>& strands, const Ground& ground,
          Progress& progress) {
    Joiner joiner(spikes, strands, ground);
    joiner.join();
    joiner.warn(progress);
}

}  // namespace cydonia::texture
