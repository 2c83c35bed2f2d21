#include "synth/pareidolia/slopes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "synth/distance/cost_model.h"

namespace cydonia::pareidolia {
namespace {

// How far in front of a crest land may rise to it without a limit, as a share of the
// terrain's width, and how steeply.
constexpr double kFrontReach = 0.04;
constexpr float kFrontFactor = 2.0f;
// Inside a shadow only its line of light limits the land.
constexpr float kInsideFactor = 3.0f;
// Across the light land may rise from crests this many times as fast as along it.
constexpr double kAcross = 1.5;

Field<float> uniform(const ShadowPlan& plan, double factor) {
    return Field<float>(plan.width(), plan.height(), static_cast<float>(factor));
}

void mark_inside(const Field<std::uint8_t>& inside, Field<float>& factor) {
    for (std::size_t i = 0; i < factor.size(); ++i)
        if (inside[i]) factor[i] = kInsideFactor;
}

// The factors of the edges in each direction; 1 along the light.
std::vector<float> across_stretch(const distance::Graph& graph, double across,
                                  const LightFrame& frame) {
    std::vector<float> stretch;
    const int node = graph.node(graph.width / 2, graph.height / 2);
    for (int d = 0; d < graph.directions / 2; ++d) {
        const double dx = graph.x_of(node + graph.step[d]) - graph.x_of(node);
        const double dy = graph.y_of(node + graph.step[d]) - graph.y_of(node);
        const double u = (dx * frame.along.x + dy * frame.along.y) / std::hypot(dx, dy);
        const double v = (dx * frame.across.x + dy * frame.across.y) / std::hypot(dx, dy);
        stretch.push_back(static_cast<float>(std::hypot(u, across * v)));
    }
    return stretch;
}

}  // namespace

Slopes flank_slopes(const ShadowPlan& plan, double lit, double steep, double share) {
    Field<float> factor = uniform(plan, lit);
    for (const Run& run : plan.runs) {
        const double scarp = std::max(share * plan.length(run), 1.0);
        each_cell(plan, run, [&](Cell c, double behind) {
            if (behind <= scarp) factor(c.x, c.y) = static_cast<float>(steep);
        });
    }
    return {std::move(factor)};
}

Slopes end_slopes(const ShadowPlan& plan, const Field<std::uint8_t>& inside, double lit) {
    Field<float> factor = uniform(plan, lit);
    const int front = static_cast<int>(kFrontReach * plan.width() * plan.frame.density);
    for (const Run& run : plan.runs) {
        for (int i = run.first - front; i < run.first; i += 2) {
            const Cell c = cell_of(plan.frame.position(i, run.row));
            if (factor.contains(c.x, c.y)) factor(c.x, c.y) = kFrontFactor;
        }
    }
    mark_inside(inside, factor);
    return {std::move(factor)};
}

Slopes crest_slopes(const ShadowPlan& plan, const Field<std::uint8_t>& inside,
                    double lit) {
    Field<float> factor = uniform(plan, lit);
    mark_inside(inside, factor);
    return {std::move(factor), kAcross};
}

distance::Graph scaled(const distance::Graph& graph, const Slopes& slopes,
                       const LightFrame& frame) {
    distance::Graph result = graph;
    const int half = graph.directions / 2;
    const auto stretch = across_stretch(graph, slopes.across, frame);
    for (int y = 0; y < graph.height; ++y) {
        for (int x = 0; x < graph.width; ++x) {
            const int node = graph.node(x, y);
            for (int d = 0; d < half; ++d) {
                const int other = node + graph.step[d];
                const int ox = graph.x_of(other), oy = graph.y_of(other);
                if (!slopes.factor.contains(ox, oy)) continue;
                result.weights[static_cast<std::size_t>(node) * half + d] *=
                    0.5f * (slopes.factor(x, y) + slopes.factor(ox, oy)) * stretch[d];
            }
        }
    }
    return result;
}

Field<float> spread(const distance::Graph& graph, const Field<float>& generators,
                    const Field<float>& profiles) {
    const float highest = *std::max_element(generators.begin(), generators.end());
    std::vector<distance::Start> starts;
    std::vector<float> factors;
    for (int y = 0; y < generators.height(); ++y) {
        for (int x = 0; x < generators.width(); ++x) {
            if (generators(x, y) == kNowhere) continue;
            starts.push_back({graph.node(x, y), highest - generators(x, y)});
            factors.push_back(profiles.empty() ? 1.0f : profiles(x, y));
        }
    }
    distance::LeastCost paths(graph);
    paths.spread(starts, distance::ConstantCostModel{starts, factors});

    Field<float> heights(generators.width(), generators.height(), kNowhere);
    if (starts.empty()) return heights;
    for (int y = 0; y < heights.height(); ++y)
        for (int x = 0; x < heights.width(); ++x)
            heights(x, y) = highest - paths[graph.node(x, y)].cost;  // eq. 5.3
    return heights;
}

Field<float> ceiling(const distance::Graph& graph, const Field<float>& points) {
    Field<float> depths = points;
    for (float& depth : depths)
        if (depth != kNowhere) depth = -depth;
    Field<float> result = spread(graph, depths);
    for (float& height : result) height = -height;
    return result;
}

Field<float> constant_profiles(const Field<float>& primary, double spacing,
                               double mean_edge_weight) {
    Field<float> profiles(primary.width(), primary.height(), 1.0f);
    const auto drop_to = [&](int x, int y, int dx, int dy) {
        if (!primary.contains(x + dx, y + dy) || primary(x + dx, y + dy) == kNowhere)
            return 0.0;
        const double drop = primary(x, y) - primary(x + dx, y + dy);
        return drop / (spacing * std::hypot(dx, dy));
    };
    for (int y = 0; y < primary.height(); ++y) {
        for (int x = 0; x < primary.width(); ++x) {
            if (primary(x, y) == kNowhere) continue;
            double steepest = mean_edge_weight;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    if (dx != 0 || dy != 0)
                        steepest = std::max(steepest, drop_to(x, y, dx, dy));
            profiles(x, y) = static_cast<float>(steepest / mean_edge_weight);
        }
    }
    return profiles;
}

}  // namespace cydonia::pareidolia
