// B. Rusnell, "Distance-based terrain synthesis" (2009), section 3.3, step 1.

#include "synth/distance/graph.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "field/error.h"
#include "field/parallel.h"
#include "field/random.h"
#include "synth/distance/map.h"

namespace cydonia::distance {
namespace {

using Step = Graph::Offset;
// From east, clockwise; then the knight's moves of the 16-neighbourhood.
constexpr std::array<Step, 8> kForward{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {2, 1}, {1, 2}, {-1, 2}, {-2, 1}}};

constexpr int kBandRows = 16;
constexpr int kMaxSubdivision = 16;

// A nearly normal random number of variance 1 at a lattice point: the sum of four uniform
// ones.
float lattice_normal(std::uint64_t row, std::int64_t x) {
    const std::uint64_t h = mix(row ^ static_cast<std::uint64_t>(x));
    const auto sum =
        (h & 0xffff) + ((h >> 16) & 0xffff) + ((h >> 32) & 0xffff) + (h >> 48);
    return (static_cast<float>(sum) - 131070.0f) * (1.7320508f / 65536.0f);
}

// 2 Phi(z) - 1, within 5e-4 (Abramowitz and Stegun 7.1.27), which turns a normal number
// into one that is uniform in [-1, 1]. It uses sums and products only, so that every
// processor gives the same bytes.
float uniform_from_normal(float z) {
    const float x = std::abs(z) * 0.70710678f;
    const float p =
        1.0f + x * (0.278393f + x * (0.230389f + x * (0.000972f + x * 0.078108f)));
    const float q = p * p;
    return std::copysign(1.0f - 1.0f / (q * q), z);
}

float smooth(float t) { return t * t * (3.0f - 2.0f * t); }

// Noise that is normal with variance 1 at every point: value noise on a lattice, divided
// by its deviation at the point. The lattice is rotated against the graph so that its
// squares do not show. The object keeps the last lattice cell because neighbours in a row
// mostly share it.
class NormalNoise {
  public:
    NormalNoise(double wavelength, std::uint64_t seed)
        : per_metre_(2.0 / wavelength), seed_(seed) {}

    float operator()(double x, double y) {
        constexpr double kCos = 0.8253356149096783, kSin = 0.5646424733950354;
        const double u = (kCos * x + kSin * y) * per_metre_;
        const double v = (kCos * y - kSin * x) * per_metre_;
        const double u0 = std::floor(u), v0 = std::floor(v);
        enter(static_cast<std::int64_t>(u0), static_cast<std::int64_t>(v0));
        const float s = smooth(static_cast<float>(u - u0)), s1 = 1.0f - s;
        const float t = smooth(static_cast<float>(v - v0)), t1 = 1.0f - t;
        const float sum = t1 * (s1 * corners_[0] + s * corners_[1]) +
                          t * (s1 * corners_[2] + s * corners_[3]);
        return sum / std::sqrt((s * s + s1 * s1) * (t * t + t1 * t1));
    }

  private:
    void enter(std::int64_t i, std::int64_t j) {
        if (i == i_ && j == j_) return;
        i_ = i;
        j_ = j;
        const std::uint64_t north = mix(seed_ ^ static_cast<std::uint64_t>(j));
        const std::uint64_t south = mix(seed_ ^ static_cast<std::uint64_t>(j + 1));
        corners_ = {lattice_normal(north, i), lattice_normal(north, i + 1),
                    lattice_normal(south, i), lattice_normal(south, i + 1)};
    }

    double per_metre_;
    std::uint64_t seed_;
    std::int64_t i_ = std::numeric_limits<std::int64_t>::min(), j_ = 0;
    std::array<float, 4> corners_{};
};

// The random part of eq. 3.3 at a point, uniform in [-1, 1]: the equally weighted sum of
// octaves, the first with waves of `grain` metres and each further one with waves twice
// as long.
class GrainNoise {
  public:
    GrainNoise(double grain, int octaves, std::uint64_t seed)
        : scale_(1.0f / std::sqrt(static_cast<float>(octaves))) {
        for (int i = 0; i < octaves; ++i) {
            octaves_.emplace_back(grain * std::exp2(i), mix(seed + i));
        }
    }

    float operator()(double x, double y) {
        float sum = 0.0f;
        for (NormalNoise& octave : octaves_) sum += octave(x, y);
        return uniform_from_normal(sum * scale_);
    }

  private:
    std::vector<NormalNoise> octaves_;
    float scale_;
};

void check(const EdgeOptions& options) {
    if (!(options.mean > 0.0)) {
        throw bad_request("mean_edge_weight is {}: it must be above 0", options.mean);
    }
    if (!(options.deviation >= 0.0 && options.deviation < options.mean)) {
        throw bad_request(
            "edge_weight_deviation is {}: it must be at least 0 and below "
            "mean_edge_weight ({})",
            options.deviation, options.mean);
    }
    if (options.weights && !(std::ranges::min(options.weights->range) > 0.0)) {
        throw bad_request(
            "edge_weights range is {} to {}: both must be above 0, or paths would be "
            "free",
            options.weights->range[0], options.weights->range[1]);
    }
    if (!(options.grain > 0.0)) {
        throw bad_request("grain is {} m: it must be above 0", options.grain);
    }
    if (options.neighbours != 8 && options.neighbours != 16) {
        throw bad_request("neighbours is {}: it must be 8 or 16", options.neighbours);
    }
    if (options.neighbours == 16 && options.metric == Options::Metric::kThesis) {
        throw bad_request("metric \"thesis\" is for 8 neighbours: leave neighbours out");
    }
}

Graph empty_graph(int width, int height, double spacing, const EdgeOptions& options) {
    Graph graph;
    graph.width = width;
    graph.height = height;
    graph.spacing = spacing;
    graph.directions = options.neighbours;
    graph.margin = options.neighbours == 16 ? 2 : 1;
    graph.stride = width + 2 * graph.margin;
    const int half = graph.directions / 2;
    for (int d = 0; d < half; ++d) {
        graph.step[d] = kForward[d].y * graph.stride + kForward[d].x;
        graph.step[d + half] = -graph.step[d];
        graph.offset[d] = kForward[d];
        graph.offset[d + half] = {-kForward[d].x, -kForward[d].y};
    }
    graph.weights.resize(static_cast<std::size_t>(graph.nodes()) * half);
    return graph;
}

// The random part on a grid `subdivision` times as fine as the nodes, for some rows of
// nodes and the margin around them.
struct Samples {
    Field<float> values;
    int margin = 0;
    int subdivision = 1;

    Samples(const Graph& graph, int first_row, int rows, int fineness,
            const EdgeOptions& options, std::uint64_t seed)
        : values((graph.width + 2 * graph.margin) * fineness,
                 (rows + graph.margin) * fineness + 1),
          margin(graph.margin),
          subdivision(fineness) {
        const double fine = graph.spacing / fineness;
        const double west = (0.5 - margin) * graph.spacing;
        const double north = (first_row + 0.5) * graph.spacing;
        GrainNoise noise(options.grain, options.octaves, seed);
        for (int y = 0; y < values.height(); ++y) {
            for (int x = 0; x < values.width(); ++x) {
                values(x, y) = noise(west + fine * x, north + fine * y);
            }
        }
    }

    // The mean along the edge that leaves node (x, row) by `step`, by the trapezoid rule.
    float mean(int x, int row, Step step) const {
        const int x0 = (x + margin) * subdivision, y0 = row * subdivision;
        float sum = 0.5f * (values(x0, y0) +
                            values(x0 + step.x * subdivision, y0 + step.y * subdivision));
        for (int i = 1; i < subdivision; ++i) {
            sum += values(x0 + step.x * i, y0 + step.y * i);
        }
        return sum / static_cast<float>(subdivision);
    }
};

// The mean of a map's values at the two ends of an edge.
class MapValues {
  public:
    MapValues(const std::optional<Map>& map, double otherwise, const Graph& graph)
        : otherwise_(static_cast<float>(otherwise)) {
        if (map) values_ = map_values(*map, graph.width, graph.height);
    }
    float between(int x, int y, Step step) const {
        if (values_.empty()) return otherwise_;
        const int x1 = std::clamp(x + step.x, 0, values_.width() - 1);
        const int y1 = std::clamp(y + step.y, 0, values_.height() - 1);
        return 0.5f * (values_(x, y) + values_(x1, y1));
    }

  private:
    float otherwise_;
    Field<float> values_;
};

// The length in metres that an edge of each direction counts as.
std::array<float, 8> lengths_of(const Graph& graph, const EdgeOptions& options) {
    std::array<float, 8> lengths{};
    for (int d = 0; d < graph.directions / 2; ++d) {
        const double cells = std::hypot(kForward[d].x, kForward[d].y);
        lengths[d] = static_cast<float>(
            graph.spacing * (options.metric == Options::Metric::kThesis ? 1.0 : cells));
    }
    return lengths;
}

// The least weight of an edge: one that is a billion times lighter than others would need
// that many buckets of the queue.
constexpr float kLightest = 1e-3f;  // of the mean

// Calls weight(x, y, d) for every edge, in bands of rows. `band` is computed once for
// each band.
template <class Band>
void weigh_edges(Graph& graph, const Band& band) {
    const int half = graph.directions / 2;
    parallel_for((graph.height + kBandRows - 1) / kBandRows, [&](int index) {
        const int first = index * kBandRows;
        const int rows = std::min(kBandRows, graph.height - first);
        const auto weight = band(first, rows);
        for (int row = 0; row < rows; ++row) {
            for (int x = 0; x < graph.width; ++x) {
                float* weights =
                    &graph.weights[static_cast<std::size_t>(graph.node(x, first + row)) *
                                   half];
                for (int d = 0; d < half; ++d) weights[d] = weight(x, row, d);
            }
        }
    });
}

// Section 4.3.2. An edge takes the mean of the values at its ends rather than the value
// where it begins, so that it costs the same in both directions.
void weigh_by_picture(Graph& graph, const EdgeOptions& options) {
    const MapValues values(options.weights, 0.0, graph);
    const std::array<float, 8> lengths = lengths_of(graph, options);
    weigh_edges(graph, [&](int first, int) {
        return [&, first](int x, int row, int d) {
            return lengths[d] * values.between(x, first + row, kForward[d]);
        };
    });
}

void weigh_at_random(Graph& graph, const EdgeOptions& options, std::uint64_t seed) {
    const int fineness = static_cast<int>(std::clamp(
        std::ceil(4.0 * graph.spacing / options.grain), 1.0, 1.0 * kMaxSubdivision));
    const std::array<float, 8> lengths = lengths_of(graph, options);
    const MapValues means(options.mean_map, options.mean, graph);
    const MapValues deviations(options.deviation_map, options.deviation, graph);
    weigh_edges(graph, [&](int first, int rows) {
        return [&, first, noise = Samples(graph, first, rows, fineness, options, seed)](
                   int x, int row, int d) {
            const float mean = means.between(x, first + row, kForward[d]);
            const float deviation = deviations.between(x, first + row, kForward[d]);
            // Rusnell 2009, eq. 3.3
            const float weight = mean + deviation * noise.mean(x, row, kForward[d]);
            return lengths[d] * std::max(weight, kLightest * mean);
        };
    });
}

}  // namespace

EdgeOptions edges_of(const Options& options, double width) {
    return {options.mean_edge_weight,     options.edge_weight_deviation,
            options.grain.in(width),      options.metric,
            options.neighbours,           3,
            options.mean_edge_weight_map, options.edge_weight_deviation_map,
            options.edge_weights};
}

Graph graph_of(int width, int height, double spacing, const EdgeOptions& options,
               std::uint64_t seed) {
    check(options);
    Graph graph = empty_graph(width, height, spacing, options);
    if (options.weights) {
        weigh_by_picture(graph, options);
    } else {
        weigh_at_random(graph, options, hash_of({seed, key("edge weight")}));
    }
    return graph;
}

float least_edge(const Graph& graph) {
    const int half = graph.directions / 2;
    float least = std::numeric_limits<float>::infinity();
    for (int y = 0; y < graph.height; ++y) {
        for (int d = 0; d < half; ++d) {
            const Step step = kForward[d];
            if (y + step.y >= graph.height) continue;
            const int first = std::max(0, -step.x);
            const int last = graph.width - std::max(0, step.x);
            for (int x = first; x < last; ++x) {
                least = std::min(
                    least,
                    graph.weights[static_cast<std::size_t>(graph.node(x, y)) * half + d]);
            }
        }
    }
    return std::isfinite(least) ? least : 1.0f;
}

Graph layout_graph(const Graph& graph, const EdgeOptions& options, std::uint64_t seed) {
    constexpr double kFewest = 64, kMost = 1024;
    const double longer = std::max(graph.width, graph.height) * graph.spacing;
    const double apart =
        longer / std::clamp(std::round(4.0 * longer / options.grain), kFewest, kMost);
    const auto nodes = [&](int cells) {
        return std::max(1, static_cast<int>(std::round(cells * graph.spacing / apart)));
    };
    const int width = nodes(graph.width), height = nodes(graph.height);
    if (width == graph.width && height == graph.height) return graph;
    return graph_of(width, height, apart, options, seed);
}

}  // namespace cydonia::distance
