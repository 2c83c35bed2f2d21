#include "synth/genetic/map/boundary.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "field/random.h"

namespace cydonia::genetic {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kPopulation = 5, kCycles = 20;      // docs/papers.md, Saunders 2006, 2
constexpr int kGenes = 12;                        // of one run, at most
constexpr double kSteepest = 60.0 * kPi / 180.0;  // the thesis' absolute angle limit
constexpr double kOffset = 1.1;                   // of eq. IV.3
constexpr double kCourse = 0.5;                   // weight in the fitness
// Fitness below which a boundary leaves its room; all others are fitter.
constexpr double kBad = -10.0, kWorst = -1e3;
constexpr int kSofter = 6;          // attempts to bend less and stay inside the room
constexpr double kLeastBent = 0.3;  // first bends, as a share of the absolute angle limit
constexpr double kRounding = 1e-9;
constexpr double kOfFree = 0.45;  // share of the angle to the next boundary at a corner

// Eq. IV.3, with |alpha| for alpha (docs/papers.md, Saunders 2006, 1).
double smooth(double turn, double s) {
    return std::sin((kPi - std::abs(turn)) * (kOffset - s));
}

// The room around a line along the x axis from 0 to 1. It is convex, so that chords stay
// inside.
struct Room {
    double envelope;               // share of the line's length
    std::array<double, 2> slopes;  // most |y| over the distance from each end

    double beyond(const Point2& p) const {
        return std::abs(p[1]) -
               std::min({envelope, slopes[0] * p[0], slopes[1] * (1.0 - p[0])});
    }
};
// The room of a part of a boundary. A part is no steeper than kSteepest against the
// whole, and this kite is no wider than 2 * 22 degrees at its ends. Each part then keeps
// to its own stretch of the whole's axis, and no two parts can cross.
constexpr Room kPart{0.2, {0.4, 0.4}};

// A frame: the x axis from 0 to 1, moved, and turned and scaled by a complex number.
struct Frame {
    Point2 from, way;

    Point2 operator()(const Point2& p) const {
        return {from[0] + p[0] * way[0] - p[1] * way[1],
                from[1] + p[0] * way[1] + p[1] * way[0]};
    }
    // This frame as seen from another one.
    Frame seen_from(const Frame& other) const {
        const double square = other.way[0] * other.way[0] + other.way[1] * other.way[1];
        const auto over = [&](const Point2& p) -> Point2 {
            return {(p[0] * other.way[0] + p[1] * other.way[1]) / square,
                    (p[1] * other.way[0] - p[0] * other.way[1]) / square};
        };
        return {over({from[0] - other.from[0], from[1] - other.from[1]}), over(way)};
    }
};

// The points of a chromosome along the x axis from 0 to 1 (eq. IV.4).
void decode(const std::vector<double>& turns, std::vector<Point2>& points) {
    points.assign(1, {0.0, 0.0});
    double angle = 0.0;
    for (const double turn : turns) {
        angle += turn;
        points.push_back(
            {points.back()[0] + std::cos(angle), points.back()[1] + std::sin(angle)});
    }
    const auto [ex, ey] = points.back();
    const double square = ex * ex + ey * ey;
    for (Point2& p : points)
        p = {(p[0] * ex + p[1] * ey) / square, (p[1] * ex - p[0] * ey) / square};
}

// The task of one run, along the x axis from 0 to 1.
struct Run {
    double smoothness;
    // Its own room, and those of all boundaries that it is a part of, with their frames.
    std::vector<std::pair<Room, Frame>> rooms;
    std::array<double, 2> course;
    std::array<bool, 2> has_course;
};

double turn_at(const std::vector<Point2>& p, std::size_t i, std::size_t step) {
    const double ax = p[i][0] - p[i - step][0], ay = p[i][1] - p[i - step][1],
                 bx = p[i + step][0] - p[i][0], by = p[i + step][1] - p[i][1];
    return std::atan2(ax * by - ay * bx, ax * bx + ay * by);
}

// The fitness of a chromosome with these points.
double fitness(const std::vector<double>& turns, const std::vector<Point2>& p,
               const Run& run) {
    static const double kSteep = std::tan(kSteepest);
    for (std::size_t i = 1; i < p.size(); ++i)
        if (!(std::abs(p[i][1] - p[i - 1][1]) <=
              kSteep * (p[i][0] - p[i - 1][0]) + kRounding))
            return kWorst;
    double beyond = 0.0;
    for (const auto& [room, frame] : run.rooms)
        for (std::size_t i = 1; i + 1 < p.size(); ++i)
            beyond = std::max(beyond, room.beyond(frame(p[i])));
    if (beyond > kRounding) return std::max(kWorst, kBad - beyond);
    // The sharpness is measured at several scales, so that the boundary looks equally
    // rough from far and near (VI.1.2). The turns at the finest scale are the genes.
    double sum = 0.0;
    int scales = 0;
    for (std::size_t step = 1; 2 * step < p.size(); step *= 2, ++scales) {
        double of_scale = 0.0;
        int count = 0;
        for (std::size_t i = step; i + step < p.size(); i += step, ++count)
            of_scale +=
                smooth(step == 1 ? turns[i] : turn_at(p, i, step), run.smoothness);
        sum += of_scale / std::max(1, count);
    }
    const auto off = [&](std::size_t end) {
        if (!run.has_course[end]) return 0.0;
        const Point2 &a = end == 0 ? p[0] : p[p.size() - 2],
                     &b = end == 0 ? p[1] : p.back();
        return std::abs(std::atan2(b[1] - a[1], b[0] - a[0]) - run.course[end]);
    };
    return sum / std::max(1, scales) - kCourse * (off(0) + off(1));
}

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    double unit() { return cydonia::unit(state_ = mix(state_)); }
    double signed_unit() { return 2.0 * unit() - 1.0; }
    std::size_t below(std::size_t n) {
        return std::min(std::size_t(unit() * double(n)), n - 1);
    }

  private:
    std::uint64_t state_;
};

struct Chromosome {
    std::vector<double> turns;
    double fitness = -1e9;
};

std::vector<Point2> evolved(const Run& run, int genes, std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Chromosome> population;
    std::vector<Point2> points;
    const auto add = [&](std::vector<double> turns) {
        decode(turns, points);
        const double value = fitness(turns, points, run);
        population.push_back({std::move(turns), value});
    };
    const auto rank = [&] {
        std::ranges::stable_sort(population, std::greater<>{}, &Chromosome::fitness);
        population.resize(std::min<std::size_t>(population.size(), kPopulation));
    };
    const auto n = std::size_t(genes);
    for (int i = 0; i < kPopulation; ++i) {
        std::vector<double> turns(n);
        double angle = 0.0;
        const double most = kSteepest * (kLeastBent + (1.0 - kLeastBent) * dice.unit());
        for (double& turn : turns) {
            const double next = most * dice.signed_unit();
            turn = next - angle, angle = next;
        }
        add(turns);
        for (int k = 0; k < kSofter && population.back().fitness <= kBad; ++k) {
            for (double& turn : turns) turn *= 0.5;
            population.pop_back();
            add(turns);
        }
    }
    rank();
    for (int cycle = 0; cycle < kCycles; ++cycle) {
        for (int i = 0; i < kPopulation; ++i) {
            std::vector<double> child = population[dice.below(population.size())].turns;
            if (dice.unit() < 0.5) {  // splice
                const auto& other = population[dice.below(population.size())].turns;
                const std::size_t at = dice.below(n);
                std::copy(other.begin() + std::ptrdiff_t(at), other.end(),
                          child.begin() + std::ptrdiff_t(at));
            }
            // A bend, which the next turn may undo.
            const std::size_t bends = 1 + dice.below(3);
            for (std::size_t b = 0; b < bends; ++b) {
                const std::size_t at = dice.below(n);
                const double bend = kSteepest * dice.signed_unit() * dice.unit();
                child[at] += bend;
                if (at + 1 < n && dice.unit() < 0.7) child[at + 1] -= bend;
            }
            add(std::move(child));
        }
        rank();
    }
    // The straight line keeps within all limits. It is not a member of the population,
    // because from S = 0.6 on nothing else is as smooth, and every boundary would stay
    // straight.
    if (population.front().fitness <= kBad) population.front().turns.assign(n, 0.0);
    decode(population.front().turns, points);
    points.front() = {0.0, 0.0}, points.back() = {1.0, 0.0};
    return points;
}

class Refinement {
  public:
    Refinement(const StraightBoundary& boundary, std::vector<Point2>& line)
        : boundary_(boundary), line_(line) {}

    // Appends the points that replace the straight line from the last point to `to`.
    void add(const Point2& to, const Room& room, const std::array<double, 2>& course,
             const std::array<bool, 2>& has_course, std::uint64_t seed) {
        const Point2 from = line_.back();
        const Frame own{from, {to[0] - from[0], to[1] - from[1]}};
        const double length = std::hypot(own.way[0], own.way[1]);
        if (!(length > boundary_.segment) || !shows(from, to, room.envelope * length)) {
            line_.push_back(to);
            return;
        }
        around_.emplace_back(room, own);
        Run run{boundary_.smoothness, {}, course, has_course};
        for (const auto& [other, frame] : around_)
            run.rooms.emplace_back(other, own.seen_from(frame));
        for (std::size_t end = 0; end < 2; ++end) {
            const double most =
                std::min(0.9 * kSteepest, std::atan(0.9 * room.slopes[end]));
            run.course[end] = std::clamp(course[end], -most, most);
        }
        const double parts = std::ceil(length / boundary_.segment);
        const std::vector<Point2> points =
            evolved(run, int(std::clamp(parts, 2.0, double(kGenes))), seed);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            // The course at the ends as seen from the part, which is turned itself.
            const double turned = std::atan2(points[i + 1][1] - points[i][1],
                                             points[i + 1][0] - points[i][0]);
            const bool first = i == 0, last = i + 2 == points.size();
            add(last ? to : own(points[i + 1]), kPart,
                {course[0] - turned, course[1] - turned},
                {first && has_course[0], last && has_course[1]}, hash_of({seed, i}));
        }
        around_.pop_back();
    }

  private:
    bool shows(const Point2& a, const Point2& b, double stray) const {
        const auto& [west, south, east, north] = boundary_.window;
        return std::max(a[0], b[0]) + stray >= west &&
               std::min(a[0], b[0]) - stray <= east &&
               std::max(a[1], b[1]) + stray >= south &&
               std::min(a[1], b[1]) - stray <= north;
    }

    const StraightBoundary& boundary_;
    std::vector<Point2>& line_;
    std::vector<std::pair<Room, Frame>>
        around_;  // of the whole, its part, that one's part ...
};

double cross(const Point2& o, const Point2& a, const Point2& b) {
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

bool meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    return cross(a, b, c) * cross(a, b, d) <= 0.0 &&
           cross(c, d, a) * cross(c, d, b) <= 0.0 &&
           std::max(a[0], b[0]) >= std::min(c[0], d[0]) &&
           std::max(c[0], d[0]) >= std::min(a[0], b[0]) &&
           std::max(a[1], b[1]) >= std::min(c[1], d[1]) &&
           std::max(c[1], d[1]) >= std::min(a[1], b[1]);
}

}  // namespace

std::optional<Point2> crossing_of(const std::vector<Point2>& line) {
    // Segments are sorted by their begin along the axis along which they are shorter, and
    // each is compared with those that begin before it ends.
    const std::size_t n = line.size() < 2 ? 0 : line.size() - 1;
    Point2 sum{};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < 2; ++k)
            sum[k] += std::abs(line[i + 1][k] - line[i][k]);
    const std::size_t axis = sum[0] <= sum[1] ? 0 : 1;
    const auto begin = [&](std::size_t i) {
        return std::min(line[i][axis], line[i + 1][axis]);
    };
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, begin);
    const bool closed = n > 2 && line.front() == line.back();
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = order[k];
        const double end = std::max(line[i][axis], line[i + 1][axis]);
        for (std::size_t l = k + 1; l < n && begin(order[l]) <= end; ++l) {
            const std::size_t j = order[l];
            const std::size_t apart = i > j ? i - j : j - i;
            if (apart == 1 || (closed && apart == n - 1)) continue;
            const Point2 &a = line[i], &b = line[i + 1], &c = line[j], &d = line[j + 1];
            if (!meet(a, b, c, d)) continue;
            const double of_c = cross(a, b, c), of_d = cross(a, b, d);
            const double t = of_c == of_d ? 0.0 : of_c / (of_c - of_d);
            return Point2{c[0] + t * (d[0] - c[0]), c[1] + t * (d[1] - c[1])};
        }
    }
    return {};
}

std::vector<Point2> refined(const StraightBoundary& boundary, std::uint64_t seed) {
    const double length =
        std::hypot(boundary.to[0] - boundary.from[0], boundary.to[1] - boundary.from[1]);
    std::vector<Point2> line = {boundary.from};
    Room room{length > 0.0 ? boundary.envelope / length : 0.0, {}};
    for (std::size_t end = 0; end < 2; ++end)
        room.slopes[end] =
            std::tan(std::min(kOfFree * boundary.free_at[end], 70.0 * kPi / 180.0));
    Refinement(boundary, line)
        .add(boundary.to, room, boundary.course,
             {boundary.course[0] != 0.0, boundary.course[1] != 0.0}, seed);
    return line;
}

}  // namespace cydonia::genetic
