#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "synth/distance/graph.h"
#include "synth/distance/queue.h"

namespace cydonia::distance {

inline constexpr float kUnreached = std::numeric_limits<float>::infinity();

// A generator node. Its index in the list of starts identifies it: paths have it as their
// `origin`.
struct Start {
    int node = 0;
    float cost = 0.0f;  // metres, not negative
};

// What a pass leaves at a node. It has sixteen bytes so that it is stored by one
// instruction: when it was stored in parts, reading it again had to wait for them, which
// took a quarter of the time.
struct alignas(16) Label {
    static constexpr std::uint8_t kStart = 255;

    float cost = kUnreached;
    float length = 0.0f;              // along the path, as its model counts it
    int origin = -1;                  // index of the start
    std::uint8_t direction = kStart;  // of the edge that the path came by
    std::uint8_t way = 0;             // the profile, in models that have several,
    std::uint8_t side = 0;            // the side of the stroke, likewise
    std::uint8_t unused = 0;
};
static_assert(sizeof(Label) == 16);

// A cost model says how cost rises along a path (synth/distance/cost_model.h). It has
//   Label begin(int origin) const               the label of a start
//   auto from(int node, const Label&) const     a function of (direction, neighbour,
//       length): the label of the neighbour on a path that is this long there. Its cost
//       is above the one before; LeastCost fills in `origin` and `direction`
//   float key(float cost) const                 rises with cost
//   float least_step(float edge) const          the least by which the key rises over an
//       edge of weight `edge`
//   kOneWay                                     true when cost is a function of origin
//   and
//       length that does not fall with length
// It is not a product of factors along the path (eq. 3.4). To first order in an edge's
// length it is the same, but it is exact at every resolution, and every beginning of a
// least-cost path is a least-cost path (docs/papers.md, Rusnell 6).

// Searches on from every node that is settled.
struct ExpandAll {
    bool operator()(int /*node*/, float /*cost*/) const { return true; }
};

// Least-cost paths over a graph, from many starts at once (Dijkstra, label-setting). Of
// equal costs the path of the lower origin holds, then the shorter, then the one of the
// lower direction, so that labels do not depend on the queue. One object serves many
// passes; each touches only the cells it reaches.
class LeastCost {
  public:
    explicit LeastCost(const Graph& graph)
        : graph_(&graph),
          least_edge_(least_edge(graph)),
          labels_(static_cast<std::size_t>(graph.nodes())) {
        // No path enters the margin, because no cost is below that of its labels.
        const auto wall = [&](int first, int last) {
            for (int node = first; node < last; ++node) labels_[node].cost = -kUnreached;
        };
        const int rows = graph.height + 2 * graph.margin;
        wall(0, graph.margin * graph.stride);
        wall((rows - graph.margin) * graph.stride, graph.nodes());
        for (int y = 0; y < graph.height; ++y) {
            wall(graph.node(-graph.margin, y), graph.node(0, y));
            wall(graph.node(graph.width, y), graph.node(graph.width + graph.margin, y));
        }
    }

    // Labels what can be reached from the starts; forgets the pass before. A node for
    // which expand(node, cost) is false keeps its label but is not searched on from.
    template <class CostModel, class Expand = ExpandAll>
    void spread(std::span<const Start> starts, const CostModel& model,
                const Expand& expand = {}) {
        begin_pass(model);
        for (std::size_t i = 0; i < starts.size(); ++i) {
            Label label = model.begin(static_cast<int>(i));
            label.origin = static_cast<int>(i);
            label.direction = Label::kStart;
            improve(starts[i].node, label, model);
        }
        settle(model, expand);
    }

    // What a pass left behind: its nodes, each after those of its path, with their
    // labels, and 1 for each node from which it searched on.
    struct Trace {
        std::vector<int> nodes;
        std::vector<Label> labels;
        std::vector<std::uint8_t> expanded;
    };

    // The labels that spread() would find with the same starts and model, from those of
    // a pass with another `expand`: keeps what still holds and settles only the rest
    // (Ramalingam and Reps 1996, for one source). Returns how many nodes it settled; none
    // where a label that held does not follow from the one before it any more: with
    // several starts a cheaper beginning may lead to a dearer end.
    template <class CostModel, class Expand>
    std::optional<std::size_t> spread_again(const Trace& trace, const CostModel& model,
                                            const Expand& expand) {
        begin_pass(model);
        std::vector<int> held, again;
        for (std::size_t i = 0; i < trace.nodes.size(); ++i) {
            const int node = trace.nodes[i];
            const Label& label = trace.labels[i];
            if (label.direction != Label::kStart) {
                const int before = node - graph_->step[label.direction];
                const float cost = labels_[before].cost;
                if (cost == kUnreached || !expand(before, cost)) continue;  // lost
            }
            labels_[node] = label;
            held.push_back(node);
            if (!trace.expanded[i] && expand(node, label.cost)) again.push_back(node);
        }
        // Paths from the nodes that were kept may lead to those that were lost.
        for (int node : trace.nodes) {
            if (labels_[node].cost != kUnreached) continue;
            for (int d = 0; d < graph_->directions; ++d) {
                const int from = node + graph_->step[d];
                const float cost = labels_[from].cost;
                if (std::isfinite(cost) && expand(from, cost)) again.push_back(from);
            }
        }
        sort_uniquely(again);
        for (int node : again) {
            queue_.push(model.key(labels_[node].cost), labels_[node].cost, node);
        }
        settle(model, expand);
        const std::size_t count = settled_.size();
        settled_.insert(settled_.end(), held.begin(), held.end());
        const auto sound = [&](int node) { return follows(node, model); };
        if (!std::ranges::all_of(held, sound)) return std::nullopt;
        sort_uniquely(settled_);
        std::ranges::sort(settled_, {}, [&](int node) { return labels_[node].cost; });
        return count;
    }

    const Label& operator[](int node) const { return labels_[node]; }
    // The nodes of the last pass; every node comes after those of its path.
    std::span<const int> settled() const { return settled_; }

  private:
    static void sort_uniquely(std::vector<int>& nodes) {
        std::ranges::sort(nodes);
        nodes.erase(std::ranges::unique(nodes).begin(), nodes.end());
    }

    // Whether a label follows from the one before it on its path.
    template <class CostModel>
    bool follows(int node, const CostModel& model) const {
        const Label& label = labels_[node];
        if (label.direction == Label::kStart) return true;
        const int before = node - graph_->step[label.direction];
        const Label& from = labels_[before];
        const float length = from.length + graph_->edge(before, label.direction);
        return from.origin == label.origin &&
               model.from(before, from)(label.direction, node, length).cost == label.cost;
    }

    template <class CostModel>
    void begin_pass(const CostModel& model) {
        for (int node : settled_) labels_[node] = Label{};
        settled_.clear();
        // A little narrower than the least step, for the rounding of keys.
        queue_.reset(0.95f * model.least_step(least_edge_));
    }

    template <class CostModel, class Expand>
    void settle(const CostModel& model, const Expand& expand) {
        if (graph_->directions == 8) {
            settle_all<4>(model, expand);
        } else {
            settle_all<8>(model, expand);
        }
    }

    // Which of two labels with equal costs holds.
    static bool before(const Label& a, const Label& b) {
        if (a.origin != b.origin) return a.origin < b.origin;
        if (a.length != b.length) return a.length < b.length;
        return a.direction < b.direction;
    }

    template <class CostModel>
    void improve(int node, const Label& label, const CostModel& model) {
        Label& known = labels_[node];
        if (label.cost < known.cost) {
            known = label;
            queue_.push(model.key(label.cost), label.cost, node);
        } else if (label.cost == known.cost && before(label, known)) {
            known = label;  // in the queue already
        }
    }

    template <int kHalf, class CostModel, class Expand>
    void settle_all(const CostModel& model, const Expand& expand) {
        using Entry = BucketQueue::Entry;
        const float* const weights = graph_->weights.data();
        const auto row = [](int node) { return static_cast<std::size_t>(node) * kHalf; };
        queue_.drain([&](Entry entry, Entry upcoming) {
            __builtin_prefetch(&labels_[upcoming.node]);
            __builtin_prefetch(weights + row(upcoming.node));
            const int node = entry.node;
            const Label label = labels_[node];
            if (label.cost != entry.cost) return;  // overtaken
            settled_.push_back(node);
            if (!expand(node, label.cost)) return;

            // Which steps are worth taking is found without a branch: it is as good as
            // random, and the processor's mispredictions would cost more than all the
            // rest.
            std::array<int, 2 * kHalf> neighbours;
            std::array<float, 2 * kHalf> lengths;
            std::uint32_t worth = 0;
            const auto look = [&](int direction, int neighbour, float weight) {
                const Label& known = labels_[neighbour];
                const float length = label.length + weight;
                neighbours[direction] = neighbour;
                lengths[direction] = length;
                bool better = known.cost > label.cost;  // no edge costs nothing
                if constexpr (CostModel::kOneWay) {
                    better &= (known.origin != label.origin) | (length <= known.length);
                }
                worth |= static_cast<std::uint32_t>(better) << direction;
            };
            for (int d = 0; d < kHalf; ++d) {
                const int step = graph_->step[d];
                look(d, node + step, weights[row(node) + d]);
                look(d + kHalf, node - step, weights[row(node - step) + d]);
            }
            const auto grow = model.from(node, label);
            for (; worth != 0; worth &= worth - 1) {
                const int direction = std::countr_zero(worth);
                Label there = grow(direction, neighbours[direction], lengths[direction]);
                there.origin = label.origin;
                there.direction = static_cast<std::uint8_t>(direction);
                improve(neighbours[direction], there, model);
            }
        });
    }

    const Graph* graph_;
    float least_edge_;
    std::vector<Label> labels_;
    std::vector<int> settled_;
    BucketQueue queue_;
};

// The nodes of the least-cost path that ends at `node`, from there back to its start.
inline std::vector<int> path_back(const Graph& graph, const LeastCost& paths, int node) {
    std::vector<int> nodes{node};
    while (paths[node].direction != Label::kStart) {
        node -= graph.step[paths[node].direction];
        nodes.push_back(node);
    }
    return nodes;
}

}  // namespace cydonia::distance
