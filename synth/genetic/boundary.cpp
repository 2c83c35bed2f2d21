#include "synth/genetic/boundary.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "field/random.h"

namespace cydonia::genetic {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kPopulation = 5, kCycles = 20;      // notes.md, Saunders 2006, 2
constexpr int kGenes = 12;                        // of one run
constexpr double kSteepest = 60.0 * kPi / 180.0;  // the absolute angle limit
constexpr double kOffset = 1.1;                   // of eq. IV.3
constexpr double kRoom = 0.2;  // how far a part may stray, of its length
constexpr double kCourse = 0.5, kOutside = 4.0;  // weights in the fitness
constexpr int kTries = 6;

// Eq. IV.3; alpha is meant as its size (notes.md).
double smooth(double turn, double s) {
    return std::sin((kPi - std::abs(turn)) * (kOffset - s));
}

// Points of a chromosome along the x axis from 0 to 1 (eq. IV.4).
std::vector<Point2> decoded(const std::vector<double>& turns) {
    std::vector<Point2> points = {{0.0, 0.0}};
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
    return points;
}

// One run's task: along the x axis from 0 to 1.
struct Run {
    double smoothness;
    double envelope;               // of its length
    std::array<double, 2> slopes;  // most |y| over the distance from each end
    std::array<double, 2> course;
    std::array<double, 2> course_weight;

    double room(double x) const {
        return std::min({envelope, slopes[0] * x, slopes[1] * (1.0 - x)});
    }
};

double turn_at(const std::vector<Point2>& p, std::size_t i, std::size_t step) {
    const double a = std::atan2(p[i][1] - p[i - step][1], p[i][0] - p[i - step][0]),
                 b = std::atan2(p[i + step][1] - p[i][1], p[i + step][0] - p[i][0]);
    return std::remainder(b - a, 2.0 * kPi);
}

double fitness(const std::vector<double>& turns, const Run& run) {
    double angle = 0.0;
    for (const double turn : turns)
        if (std::abs(angle += turn) > kSteepest) return -1e3;
    const std::vector<Point2> p = decoded(turns);
    // At several scales, so that it bends as much from far and from near.
    double sum = 0.0;
    int scales = 0;
    for (std::size_t step = 1; 2 * step < p.size(); step *= 2, ++scales) {
        double of_scale = 0.0;
        int count = 0;
        for (std::size_t i = step; i + step < p.size(); i += step, ++count)
            of_scale += smooth(turn_at(p, i, step), run.smoothness);
        sum += of_scale / std::max(1, count);
    }
    double outside = 0.0;
    for (std::size_t i = 1; i + 1 < p.size(); ++i)
        outside = std::max(outside, std::abs(p[i][1]) - run.room(p[i][0]));
    const auto off = [&](std::size_t end) {
        const Point2 &a = end == 0 ? p[0] : p[p.size() - 2],
                     &b = end == 0 ? p[1] : p.back();
        return run.course_weight[end] *
               std::abs(std::atan2(b[1] - a[1], b[0] - a[0]) - run.course[end]);
    };
    return sum / std::max(1, scales) - kCourse * (off(0) + off(1)) -
           (outside > 0.0 ? kOutside + outside : 0.0);
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
    const auto add = [&](std::vector<double> turns) {
        const double value = fitness(turns, run);
        population.push_back({std::move(turns), value});
    };
    const auto rank = [&] {
        std::ranges::stable_sort(population, std::greater<>{}, &Chromosome::fitness);
        population.resize(std::min<std::size_t>(population.size(), kPopulation));
    };
    const auto n = std::size_t(genes);
    add(std::vector<double>(n, 0.0));  // the straight line, which keeps to all limits
    for (int i = 1; i < kPopulation; ++i) {
        std::vector<double> turns(n);
        double angle = 0.0;
        const double most = kSteepest * dice.unit();
        for (double& turn : turns) {
            const double next = most * dice.signed_unit();
            turn = next - angle, angle = next;
        }
        add(std::move(turns));
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
            // Bends, made good by the next turn or not.
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
    std::vector<Point2> points = decoded(population.front().turns);
    points.front() = {0.0, 0.0}, points.back() = {1.0, 0.0};
    return points;
}

void refine(const Point2& a, const Point2& b, Run run, double segment, std::uint64_t seed,
            std::vector<Point2>& line) {
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
    const double parts = length / segment;
    if (!(parts > 1.0)) {
        line.push_back(b);
        return;
    }
    const int genes = std::clamp(int(std::ceil(parts)), 2, kGenes);
    std::vector<Point2> points = evolved(run, genes, seed);
    for (Point2& p : points)
        p = {a[0] + p[0] * dx - p[1] * dy, a[1] + p[0] * dy + p[1] * dx};
    points.front() = a, points.back() = b;
    // Parts keep to diamonds that do not meet, so that they cannot cross.
    run.envelope = std::min(run.envelope, kRoom);
    run.slopes = {2.0 * kRoom, 2.0 * kRoom};
    run.course_weight = {0.0, 0.0};
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        refine(points[i], points[i + 1], run, segment, hash_of({seed, i}), line);
}

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

bool crosses_itself(const std::vector<Point2>& line) {
    // Segments by where they begin from west to east, each against those that begin
    // before it ends.
    const std::size_t n = line.size() < 2 ? 0 : line.size() - 1;
    const auto west = [&](std::size_t i) { return std::min(line[i][0], line[i + 1][0]); };
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, west);
    const bool closed = n > 2 && line.front() == line.back();
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = order[k];
        const double east = std::max(line[i][0], line[i + 1][0]);
        for (std::size_t l = k + 1; l < n && west(order[l]) <= east; ++l) {
            const std::size_t j = order[l];
            const std::size_t apart = i > j ? i - j : j - i;
            if (apart == 1 || (closed && apart == n - 1)) continue;
            if (meet(line[i], line[i + 1], line[j], line[j + 1])) return true;
        }
    }
    return false;
}

std::vector<Point2> refined(const StraightBoundary& boundary, std::uint64_t seed) {
    const double length =
        std::hypot(boundary.to[0] - boundary.from[0], boundary.to[1] - boundary.from[1]);
    std::vector<Point2> line;
    if (!(length > boundary.segment)) return {boundary.from, boundary.to};
    // Parts stray too, all of them together by less than a quarter more.
    double envelope = 0.8 * boundary.envelope / length;
    for (int attempt = 0; attempt < kTries; ++attempt, envelope *= 0.5) {
        Run run{boundary.smoothness, envelope, {}, boundary.course, {1.0, 1.0}};
        for (std::size_t end = 0; end < 2; ++end) {
            run.slopes[end] =
                0.7 * std::tan(std::min(0.5 * boundary.free_at[end], 70.0 * kPi / 180.0));
            const double most = std::atan(0.9 * run.slopes[end]);
            run.course[end] = std::clamp(run.course[end], -most, most);
            if (boundary.course[end] == 0.0) run.course_weight[end] = 0.0;
        }
        line = {boundary.from};
        refine(boundary.from, boundary.to, run, boundary.segment,
               hash_of({seed, std::uint64_t(attempt)}), line);
        if (!crosses_itself(line)) return line;
    }
    return {boundary.from, boundary.to};
}

}  // namespace cydonia::genetic
