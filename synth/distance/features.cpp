// B. Rusnell, "Distance-based terrain synthesis" (2009), sections 3.2, 4.1 and 5.4.

#include "synth/distance/features.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/random.h"
#include "field/strokes.h"

namespace cydonia::distance {
namespace {

// A generator on the ground: metres from the north-west corner.
struct Place {
    double x, y;
    float cost;
};
using FeatureList = std::vector<std::vector<Place>>;

Place centre_of(const Graph& graph, int node) {
    return {(graph.x_of(node) + 0.5) * graph.spacing,
            (graph.y_of(node) + 0.5) * graph.spacing, 0.0f};
}

int node_at(const Graph& graph, const Place& place) {
    const auto cell = [&](double metres, int cells) {
        return std::clamp(static_cast<int>(metres / graph.spacing), 0, cells - 1);
    };
    return graph.node(cell(place.x, graph.width), cell(place.y, graph.height));
}

std::uint64_t draw(std::uint64_t seed, const char* purpose, int index) {
    return hash_of({seed, key(purpose), static_cast<std::uint64_t>(index)});
}

// The same place on the ground at every resolution.
Place random_place(const Graph& graph, std::uint64_t seed, const char* purpose,
                   int index) {
    const std::uint64_t h = draw(seed, purpose, index);
    return {unit(mix(h ^ 1)) * graph.width * graph.spacing,
            unit(mix(h ^ 2)) * graph.height * graph.spacing, 0.0f};
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
        std::vector<Place>& places = features.emplace_back();
        for (int c : piece) {
            places.push_back(
                centre_of(graph, graph.node(c % graph.width, c / graph.width)));
        }
    }
    return features;
}

FeatureList peak_features(const Graph& graph, int count, std::uint64_t seed) {
    FeatureList features;
    for (int i = 0; i < count; ++i) {
        features.push_back({random_place(graph, seed, "peak", i)});
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
        for (Place& place : features[f]) {
            place.cost = static_cast<float>(
                rule.kind == CostRule::Kind::kRandom
                    ? random
                    : scale * noise_at(rule.noise, place.x / width, place.y / width,
                                       hash_of({seed, key("generator cost")})));
        }
    }
}

void shift_noise_to_zero(std::span<FeatureList* const> noisy) {
    float least = kUnreached;
    for (const FeatureList* list : noisy) {
        for (const auto& feature : *list) {
            for (const Place& place : feature) least = std::min(least, place.cost);
        }
    }
    for (FeatureList* list : noisy) {
        for (auto& feature : *list) {
            for (Place& place : feature) place.cost -= least;
        }
    }
}

// Section 4.1: from random places back along the least-cost path to its generator, whose
// feature the path joins; its cost is a share of the pass' (section 5.4).
void grow_ridges(FeatureList& features, const RidgeOptions& options, const Graph& graph,
                 double spacing, std::uint64_t seed) {
    std::vector<Start> starts;
    std::vector<int> feature_of;
    for (int f = 0; f < static_cast<int>(features.size()); ++f) {
        for (const Place& place : features[f]) {
            starts.push_back({node_at(graph, place), place.cost});
            feature_of.push_back(f);
        }
    }
    LeastCost paths(graph);
    paths.spread(starts, RawGrowth{starts});
    const auto place_of = [&](int node) {
        Place place = centre_of(graph, node);
        place.cost = static_cast<float>(options.cost_factor) * paths[node].cost;
        return place;
    };
    // Where the land's grid is finer, places between the nodes of a path close the gaps.
    const int parts = static_cast<int>(std::ceil(graph.spacing / spacing));
    std::vector<bool> on_ridge(static_cast<std::size_t>(graph.nodes()));
    for (int i = 0; i < options.count; ++i) {
        // Paths of one pass that meet go on as one.
        for (int node = node_at(graph, random_place(graph, seed, "ridge", i));
             node >= 0 && !on_ridge[node]; node = paths[node].from) {
            on_ridge[node] = true;
            std::vector<Place>& feature = features[feature_of[paths[node].origin]];
            const Place here = place_of(node);
            feature.push_back(here);
            if (paths[node].from < 0) break;
            const Place next = place_of(paths[node].from);
            for (int part = 1; part < parts; ++part) {
                const double t = 1.0 * part / parts;
                feature.push_back(
                    {std::lerp(here.x, next.x, t), std::lerp(here.y, next.y, t),
                     std::lerp(here.cost, next.cost, static_cast<float>(t))});
            }
        }
    }
}

Features flattened(const FeatureList& list, const Graph& graph) {
    Features features;
    for (const auto& places : list) {
        for (const Place& place : places) {
            features.starts.push_back({node_at(graph, place), place.cost});
        }
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
    if (options.ridges.count > 0) {
        const EdgeOptions edges = edges_of(options, graph.width * graph.spacing);
        grow_ridges(features, options.ridges, layout_graph(graph, edges, seed),
                    graph.spacing, seed);
    }
    return flattened(features, graph);
}

}  // namespace cydonia::distance
