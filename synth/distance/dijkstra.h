#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "synth/distance/graph.h"
#include "synth/distance/queue.h"

namespace cydonia::distance {

inline constexpr float kUnreached = std::numeric_limits<float>::infinity();

// A generator node. Its place in the list of starts is its name: the paths' `origin`.
struct Start {
    int node = 0;
    float cost = 0.0f;  // metres, not negative
};

// What a pass leaves at a node.
struct Label {
    float cost = kUnreached;
    float length = 0.0f;  // sum of the raw edge weights since the origin
    int origin = -1;      // index of the start
    int from = -1;        // the node before on the path; -1 at a start
};

// How cost grows along a path, as a function of its origin and the sum of its raw edge
// weights: growth.from(origin) returns a function of length that does not decrease, its
// value at 0 the start's cost. A function, not a factor of each edge (eq. 3.4): the
// same to first order in the edge's length, exact at every resolution, and a least-cost
// path's beginnings are least-cost paths themselves.

// Raw edge weights: no profile.
struct RawGrowth {
    std::span<const Start> starts;
    auto from(int origin) const {
        return [cost = starts[origin].cost](float length) { return cost + length; };
    }
};

// A constant profile for each start: every edge of a path times its origin's factor.
struct ConstantGrowth {
    std::span<const Start> starts;
    std::span<const float> factors;  // as many as starts, each > 0
    auto from(int origin) const {
        return [cost = starts[origin].cost, factor = factors[origin]](float length) {
            return cost + factor * length;
        };
    }
};

// Every node settled is searched on from.
struct ExpandAll {
    bool operator()(int /*node*/, float /*cost*/) const { return true; }
};

// Least-cost paths over a graph, from many starts at once (Dijkstra, label-setting):
// nodes settle in order of cost, equal costs in order of node, so labels do not depend on
// the queue. One object serves many passes; each touches only the cells it reaches.
class LeastCost {
  public:
    explicit LeastCost(const Graph& graph)
        : graph_(&graph),
          labels_(static_cast<std::size_t>(graph.nodes())),
          queue_(bucket_width(graph)) {
        for (int node = 0; node < graph.nodes(); ++node) {
            const int x = graph.x_of(node), y = graph.y_of(node);
            const bool inside = x >= 0 && y >= 0 && x < graph.width && y < graph.height;
            if (!inside) labels_[node].cost = -kUnreached;  // nothing is cheaper
        }
    }

    // Labels what can be reached from the starts; forgets the pass before. A node for
    // which expand(node, cost) is false keeps its label but is not searched on from.
    template <class Growth, class Expand = ExpandAll>
    void spread(std::span<const Start> starts, const Growth& growth,
                const Expand& expand = {}) {
        clear();
        for (std::size_t i = 0; i < starts.size(); ++i) {
            improve(starts[i].node, {starts[i].cost, 0.0f, static_cast<int>(i), -1});
        }
        if (graph_->directions == 8) {
            settle_all<4>(growth, expand);
        } else {
            settle_all<8>(growth, expand);
        }
    }

    const Label& operator[](int node) const { return labels_[node]; }
    // The nodes of the last pass, in order of cost.
    std::span<const int> settled() const { return settled_; }

  private:
    static float bucket_width(const Graph& graph) {
        const float edge = graph.edge(graph.node(graph.width / 2, graph.height / 2), 0);
        return edge / 128.0f;  // measured: 64 to 256 do
    }

    void clear() {
        for (int node : settled_) labels_[node] = Label{};
        settled_.clear();
    }

    void improve(int node, const Label& label) {
        if (!(label.cost < labels_[node].cost)) return;
        labels_[node] = label;
        queue_.push(label.cost, node);
    }

    template <int kHalf, class Growth, class Expand>
    void settle_all(const Growth& growth, const Expand& expand) {
        const float* const weights = graph_->weights.data();
        float cost = 0.0f;
        int node = 0;
        const auto alive = [labels = labels_.data()](float cost_then, int at) {
            return labels[at].cost == cost_then;
        };
        while (queue_.pop(cost, node, alive)) {
            const Label label = labels_[node];
            if (label.cost != cost) continue;  // an older, higher label of a settled node
            settled_.push_back(node);
            if (!expand(node, cost)) continue;

            const auto cost_at = growth.from(label.origin);
            const auto relax = [&](int neighbour, float weight) {
                const float length = label.length + weight;
                improve(neighbour, {cost_at(length), length, label.origin, node});
            };
            const float* const forward = weights + static_cast<std::size_t>(node) * kHalf;
            for (int d = 0; d < kHalf; ++d) {
                const int step = graph_->step[d];
                relax(node + step, forward[d]);
                relax(node - step,
                      weights[static_cast<std::size_t>(node - step) * kHalf + d]);
            }
        }
    }

    const Graph* graph_;
    std::vector<Label> labels_;
    std::vector<int> settled_;
    BucketQueue queue_;
};

// The nodes of the least-cost path that ends at `node`, back to its start.
inline std::vector<int> path_back(const LeastCost& paths, int node) {
    std::vector<int> nodes;
    for (; node >= 0; node = paths[node].from) nodes.push_back(node);
    return nodes;
}

}  // namespace cydonia::distance
