// B. Rusnell, "Distance-based terrain synthesis" (2009), sections 4.2.2, 4.5 and 6.2.

#include "synth/distance/relief.h"

#include <algorithm>
#include <cmath>

#include "field/noise.h"
#include "field/random.h"

namespace cydonia::distance {
namespace {

constexpr int kOctaves = 4;
constexpr double kStepsAWave = 8.0;  // of the shortest, so that waves keep their shape
constexpr double kMostSteps = 8192.0;

double along(CostPoint a, CostPoint b) {
    return std::hypot(b.distance - a.distance, b.cost - a.cost);
}

double length_of(std::span<const CostPoint> line) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) length += along(line[i - 1], line[i]);
    return length;
}

// A random number in (-1, 1), about as often near its ends as in the middle.
double waves(double metres, double longest, std::uint64_t seed) {
    double sum = 0.0;
    for (int octave = 0; octave < kOctaves; ++octave) {
        const double place = std::ldexp(metres / longest, octave);
        sum += gradient_noise(place, 0.5,
                              hash_of({seed, static_cast<std::uint64_t>(octave)}));
    }
    return sum / std::sqrt(0.25 + sum * sum);
}

// The line with additional points at these costs, which must rise and lie between 0 and
// its last cost.
std::vector<CostPoint> with_points_at(std::span<const CostPoint> line,
                                      std::span<const double> costs) {
    std::vector<CostPoint> points;
    auto cost = costs.begin();
    for (std::size_t i = 1; i < line.size(); ++i) {
        const CostPoint a = line[i - 1], b = line[i];
        points.push_back(a);
        for (; cost != costs.end() && *cost < b.cost; ++cost) {
            const double t = (*cost - a.cost) / (b.cost - a.cost);
            if (t > 0.0) points.push_back({std::lerp(a.distance, b.distance, t), *cost});
        }
    }
    points.push_back(line.back());
    return points;
}

}  // namespace

std::vector<CostPoint> with_detail(std::span<const CostPoint> line, double detail,
                                   double longest, std::uint64_t seed) {
    const double step = std::max(std::ldexp(longest, 1 - kOctaves) / kStepsAWave,
                                 length_of(line) / kMostSteps);
    std::vector<CostPoint> cut{line.front()};
    double metres = 0.0, cost = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const CostPoint a = line[i - 1], b = line[i];
        const double piece = along(a, b);
        const int steps = static_cast<int>(std::ceil(piece / step));
        for (int k = 1; k <= steps; ++k) {
            const double middle = metres + piece * (k - 0.5) / steps;
            const double factor = 1.0 + 0.95 * detail * waves(middle, longest, seed);
            cost += factor * (b.cost - a.cost) / steps;
            cut.push_back({std::lerp(a.distance, b.distance, 1.0 * k / steps), cost});
        }
        metres += piece;
    }
    for (CostPoint& point : cut) point.cost *= line.back().cost / cost;
    cut.back() = line.back();
    return cut;
}

std::vector<CostPoint> with_strata(std::span<const CostPoint> line,
                                   const Profile::Strata& strata) {
    // The share of a layer's width that its cliff takes, and the factors of the slopes of
    // ledge and cliff.
    const double cliff_way = std::lerp(0.5, 0.1, strata.hardness);
    const double ledge = std::max(1.0 - strata.hardness, 0.02);
    const double cliff = (1.0 - (1.0 - cliff_way) * ledge) / cliff_way;
    const double layer = line.back().cost / strata.layers;

    std::vector<double> edges;  // between cliffs and ledges
    for (int i = 0; i < strata.layers; ++i) {
        edges.insert(edges.end(), {layer * i, layer * (i + cliff_way)});
    }
    std::vector<CostPoint> cut = with_points_at(line, edges);
    for (CostPoint& point : cut) {
        const double top = std::floor(point.cost / layer);
        const double down = point.cost / layer - top;
        point.cost = layer * (top + std::min(down * cliff, 1.0 - (1.0 - down) * ledge));
    }
    cut.back() = line.back();
    return cut;
}

}  // namespace cydonia::distance
