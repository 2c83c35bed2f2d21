// B. Rusnell, "Distance-based terrain synthesis" (2009), Algorithm 3, steps 5 to 7.

#include "synth/distance/blend.h"

#include <tbb/concurrent_queue.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace cydonia::distance {
namespace {

// Features in the air at once, each with its own labels, and what all labels may take.
constexpr int kMaxPasses = 16;
constexpr double kLabelBytes = 0x1p30;

float smoothstep(float t) {
    t = std::clamp(t, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

// 0 at and below `from`, 1 from `to` on.
float fade(float value, float from, float to) {
    return to > from ? smoothstep((value - from) / (to - from)) : float(value > from);
}

// Weight lost near the sea, where a pass stops within epsilon_s of it.
float fade_at_sea(float height, float threshold) {
    return fade(height, threshold, 4.0f * threshold);
}

// Weight lost far below the approximate land, where a pass stops by p_f. A slow fade: at
// b = 0 a quick one is itself a step.
float fade_below(float ratio, float threshold) {
    return fade(ratio, threshold, std::min(8.0f * threshold, 1.0f));
}

// x^b for x in [0, 1]; whole exponents, the usual ones, by multiplication.
class Power {
  public:
    explicit Power(double exponent)
        : exponent_(static_cast<float>(exponent)),
          whole_(exponent == std::floor(exponent) && exponent <= 64.0
                     ? static_cast<int>(exponent)
                     : -1) {}
    float operator()(float x) const {
        if (whole_ < 0) return std::pow(x, exponent_);
        float result = 1.0f;
        for (int i = whole_; i > 0; i >>= 1, x *= x) {
            if (i & 1) result *= x;
        }
        return result;
    }

  private:
    float exponent_;
    int whole_;
};

// What one feature gives one cell.
struct Share {
    int node;
    float height;
    float weight;
};

struct Work {
    const Graph& graph;
    const Features& features;
    const Descent* descent;
    const BlendOptions& options;
    std::vector<float> approximate;  // heights by node, 0 where no feature comes

    template <class Expand>
    void spread(LeastCost& paths, std::span<const Start> starts,
                const Expand& expand) const {
        if (descent) {
            paths.spread(starts,
                         ProfileGrowth(*descent, starts, options.mean_edge_weight),
                         expand);
        } else {
            paths.spread(starts, RawGrowth{starts}, expand);
        }
    }
    float height_at(float cost) const {  // eq. 3.2
        return std::max(0.0f, static_cast<float>(options.sea_level) - cost);
    }
};

// Steps 5 and 6, with heights for costs (notes.md, Rusnell 5).
void lay_approximate_heights(Work& work, LeastCost& paths) {
    const auto least = static_cast<float>(work.options.sea_level_threshold);
    work.spread(paths, work.features.starts,
                [&](int, float cost) { return work.height_at(cost) > least; });
    work.approximate.assign(static_cast<std::size_t>(work.graph.nodes()), 0.0f);
    for (int node : paths.settled()) {
        work.approximate[node] = work.height_at(paths[node].cost);
    }
}

// Step 7a, and the weights of eq. 3.7. They are relative to the approximate height, which
// cancels in the sum and keeps any bias within range, and fade towards the border where
// the pass stops, so that it leaves no seam (notes.md, Rusnell 5).
std::vector<Share> shares_of(const Work& work, int feature, LeastCost& paths) {
    const auto least = static_cast<float>(work.options.sea_level_threshold);
    const auto part = static_cast<float>(work.options.approximate_threshold);
    work.spread(paths, work.features.of(feature), [&](int node, float cost) {
        const float height = work.height_at(cost);
        return height > least && height > part * work.approximate[node];
    });

    const Power power(work.options.bias);
    std::vector<Share> shares;
    shares.reserve(paths.settled().size());
    for (int node : paths.settled()) {
        const float height = work.height_at(paths[node].cost);
        if (!(height > least)) break;  // in order of cost: no higher one follows
        const float ratio = std::min(1.0f, height / work.approximate[node]);
        const float weight =
            fade_at_sea(height, least) * fade_below(ratio, part) * power(ratio);
        if (weight > 0.0f) shares.push_back({node, height, weight});
    }
    return shares;
}

// Step 7b.
struct Sums {
    std::vector<float> heights, weights, highest;

    explicit Sums(int nodes)
        : heights(static_cast<std::size_t>(nodes)),
          weights(heights.size()),
          highest(heights.size()) {}

    void add(const std::vector<Share>& shares) {
        for (const Share& share : shares) {
            heights[share.node] += share.weight * share.height;
            weights[share.node] += share.weight;
            highest[share.node] = std::max(highest[share.node], share.height);
        }
    }
    // Where the last feature stops too the land meets the sea without a step.
    float height_at(int node, float least) const {
        if (weights[node] <= 0.0f) return 0.0f;
        return fade_at_sea(highest[node], least) * (heights[node] / weights[node]);
    }
};

// Step 7 for every feature, in parallel; added up in the features' order.
void sum_features(const Work& work, std::vector<std::unique_ptr<LeastCost>>& passes,
                  Sums& sums, Progress& progress, PassCounts& counts) {
    struct Ticket {
        int feature = 0;
        LeastCost* paths = nullptr;
        std::size_t settled = 0;
        std::vector<Share> shares;
    };
    tbb::concurrent_queue<LeastCost*> free;
    for (const auto& paths : passes) free.push(paths.get());
    const int count = work.features.count();
    int next = 0;
    const auto take = [&](tbb::flow_control& control) {
        auto ticket = std::make_shared<Ticket>();
        if (next == count) {
            control.stop();
            return ticket;
        }
        ticket->feature = next++;
        free.try_pop(ticket->paths);  // never more tickets in the air than passes
        return ticket;
    };
    const auto pass = [&](std::shared_ptr<Ticket> ticket) {
        ticket->shares = shares_of(work, ticket->feature, *ticket->paths);
        ticket->settled = ticket->paths->settled().size();
        return ticket;
    };
    const auto add = [&](const std::shared_ptr<Ticket>& ticket) {
        sums.add(ticket->shares);
        counts.features += ticket->settled;
        free.push(ticket->paths);
        progress.report((ticket->feature + 1.0) / count);
    };
    using tbb::filter_mode;
    tbb::parallel_pipeline(
        passes.size(),
        tbb::make_filter<void, std::shared_ptr<Ticket>>(filter_mode::serial_in_order,
                                                        take) &
            tbb::make_filter<std::shared_ptr<Ticket>, std::shared_ptr<Ticket>>(
                filter_mode::parallel, pass) &
            tbb::make_filter<std::shared_ptr<Ticket>, void>(filter_mode::serial_in_order,
                                                            add));
}

int passes_at_once(double cells) {
    const int fit = static_cast<int>(
        std::clamp(kLabelBytes / (cells * sizeof(Label)), 1.0, 1.0 * kMaxPasses));
    return std::min(fit, tbb::this_task_arena::max_concurrency() + 1);
}

}  // namespace

Field<float> blended_heights(const Graph& graph, const Features& features,
                             const Descent* descent, const BlendOptions& options,
                             Progress& progress, PassCounts* counts) {
    Work work{graph, features, descent, options, {}};
    PassCounts counted;
    std::vector<std::unique_ptr<LeastCost>> passes(static_cast<std::size_t>(
        std::min(passes_at_once(graph.nodes()), features.count())));
    for (auto& paths : passes) paths = std::make_unique<LeastCost>(graph);

    lay_approximate_heights(work, *passes.front());
    counted.approximate = passes.front()->settled().size();
    Sums sums(graph.nodes());
    sum_features(work, passes, sums, progress, counted);

    Field<float> heights(graph.width, graph.height);
    const auto least = static_cast<float>(options.sea_level_threshold);
    for (int y = 0; y < graph.height; ++y) {
        for (int x = 0; x < graph.width; ++x) {
            heights(x, y) = sums.height_at(graph.node(x, y), least);
        }
    }
    if (counts) *counts = counted;
    return heights;
}

double blend_bytes(double cells) {
    const double pass = sizeof(Label) + sizeof(int) + sizeof(Share);
    return cells * (pass * passes_at_once(cells) + 5.0 * sizeof(float));
}

}  // namespace cydonia::distance
