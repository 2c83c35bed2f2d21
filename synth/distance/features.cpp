// B. Rusnell, "Distance-based terrain synthesis" (2009), sections 3.2, 4.1 and 5.4.

#include "synth/distance/features.h"

#include <algorithm>

#include "field/error.h"
#include "field/random.h"
#include "field/strokes.h"

namespace cydonia::distance {
namespace {

using FeatureList = std::vector<std::vector<Start>>;

std::uint64_t draw(std::uint64_t seed, const char* purpose, int index) {
    return hash_of({seed, key(purpose), static_cast<std::uint64_t>(index)});
}

// The same place on the ground at every resolution.
int random_node(const Graph& graph, std::uint64_t seed, const char* purpose, int index) {
    const std::uint64_t h = draw(seed, purpose, index);
    return graph.node(static_cast<int>(unit(mix(h ^ 1)) * graph.width),
                      static_cast<int>(unit(mix(h ^ 2)) * graph.height));
}

// The cells of the piece of one colour that holds `cell`, which are erased.
std::vector<int> taken_piece(Field<Rgba8>& strokes, int cell) {
    const Rgba8 colour = strokes[cell];
    std::vector<int> piece{cell};
    strokes[cell] = {};
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const int x0 = piece[i] % strokes.width(), y0 = piece[i] / strokes.width();
        for (int y = y0 - 1; y <= y0 + 1; ++y) {
            for (int x = x0 - 1; x <= x0 + 1; ++x) {
                if (!strokes.contains(x, y) || strokes(x, y) != colour) continue;
                strokes(x, y) = {};
                piece.push_back(y * strokes.width() + x);
            }
        }
    }
    return piece;
}

FeatureList stroke_features(const Graph& graph, Field<Rgba8> strokes) {
    FeatureList features;
    for (int cell = 0; cell < static_cast<int>(strokes.size()); ++cell) {
        if (strokes[cell][3] == 0) continue;
        std::vector<int> piece = taken_piece(strokes, cell);
        std::sort(piece.begin(), piece.end());
        std::vector<Start>& starts = features.emplace_back();
        for (int c : piece) {
            starts.push_back({graph.node(c % graph.width, c / graph.width), 0.0f});
        }
    }
    return features;
}

FeatureList peak_features(const Graph& graph, int count, std::uint64_t seed) {
    FeatureList features;
    for (int i = 0; i < count; ++i) {
        features.push_back({{random_node(graph, seed, "peak", i), 0.0f}});
    }
    return features;
}

// Unshifted noise may be negative: shift_noise_to_zero() follows.
void set_costs(FeatureList& features, const CostRule& rule, const Graph& graph,
               const char* purpose, std::uint64_t seed) {
    const double width = graph.width * graph.spacing;
    const double scale = rule.noise.scale.in(width);
    const double low = rule.range[0].in(width), high = rule.range[1].in(width);
    for (int f = 0; f < static_cast<int>(features.size()); ++f) {
        const double random = low + (high - low) * unit(draw(seed, purpose, f));
        for (Start& start : features[f]) {
            const double x = (graph.x_of(start.node) + 0.5) / graph.width;
            const double y = (graph.y_of(start.node) + 0.5) / graph.width;
            start.cost = static_cast<float>(
                rule.kind == CostRule::Kind::kRandom
                    ? random
                    : scale * noise_at(rule.noise, x, y,
                                       hash_of({seed, key("generator cost")})));
        }
    }
}

void shift_noise_to_zero(std::span<FeatureList* const> noisy) {
    float least = kUnreached;
    for (const FeatureList* list : noisy) {
        for (const auto& feature : *list) {
            for (const Start& start : feature) least = std::min(least, start.cost);
        }
    }
    for (FeatureList* list : noisy) {
        for (auto& feature : *list) {
            for (Start& start : feature) start.cost -= least;
        }
    }
}

// Section 4.1: from random nodes back along the least-cost path to its generator, whose
// feature the path joins; its cost is a share of the pass' (section 5.4).
void grow_ridges(FeatureList& features, const RidgeOptions& options, const Graph& graph,
                 std::uint64_t seed) {
    std::vector<Start> starts;
    std::vector<int> feature_of;
    for (int f = 0; f < static_cast<int>(features.size()); ++f) {
        starts.insert(starts.end(), features[f].begin(), features[f].end());
        feature_of.resize(starts.size(), f);
    }
    LeastCost paths(graph);
    paths.spread(starts, RawGrowth{starts});
    const auto share = static_cast<float>(options.cost_factor);
    std::vector<bool> on_ridge(static_cast<std::size_t>(graph.nodes()));
    for (int i = 0; i < options.count; ++i) {
        // Paths of one pass that meet go on as one.
        for (int node = random_node(graph, seed, "ridge", i);
             node >= 0 && !on_ridge[node]; node = paths[node].from) {
            on_ridge[node] = true;
            const Label& label = paths[node];
            features[feature_of[label.origin]].push_back({node, share * label.cost});
        }
    }
}

Features flattened(const FeatureList& list) {
    Features features;
    for (const auto& starts : list) {
        features.starts.insert(features.starts.end(), starts.begin(), starts.end());
        features.first.push_back(static_cast<int>(features.starts.size()));
    }
    return features;
}

}  // namespace

Features features_of(const Options& options, const Graph& graph, std::uint64_t seed) {
    FeatureList strokes;
    if (options.strokes) {
        strokes = stroke_features(
            graph, read_strokes(*options.strokes, graph.width, graph.height));
    }
    FeatureList peaks = peak_features(graph, options.peaks.count, seed);
    if (strokes.empty() && peaks.empty()) {
        throw bad_request("no features: give strokes or peaks for the land to rise from");
    }
    set_costs(strokes, options.cost, graph, "stroke cost", seed);
    set_costs(peaks, options.peaks.cost, graph, "peak cost", seed);
    std::vector<FeatureList*> noisy;
    if (options.cost.kind == CostRule::Kind::kNoise) noisy.push_back(&strokes);
    if (options.peaks.cost.kind == CostRule::Kind::kNoise) noisy.push_back(&peaks);
    shift_noise_to_zero(noisy);

    FeatureList features = std::move(strokes);
    features.insert(features.end(), peaks.begin(), peaks.end());
    if (options.ridges.count > 0) grow_ridges(features, options.ridges, graph, seed);
    return flattened(features);
}

}  // namespace cydonia::distance
