// B. Rusnell, "Distance-based terrain synthesis" (2009), Algorithm 3, step 7, and
// section 3.3.2.

#include "synth/distance/blend.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "field/smoothstep.h"
#include "synth/distance/explain.h"

namespace cydonia::distance {
namespace {

// The number of features in the pipeline at once, each of which has its own labels, and
// the memory that all labels may take.
constexpr int kMaxThreads = 16;
constexpr double kLabelBytes = 0x1p30;

// Rises from 0 at `from` and below to 1 at `to` and above.
float fade(float value, float from, float to) {
    return to > from ? smoothstep(from, to, value) : float(value > from);
}

// The factor of a weight near the sea, since a pass stops within epsilon_s of it.
float fade_at_sea(float height, float threshold) {
    return fade(height, threshold, 4.0f * threshold);
}

// The factor of a weight far below the approximate land, since a pass stops there by p_f.
// The fade is slow because at b = 0 a quick one would itself be a step.
float fade_below(float ratio, float threshold) {
    return fade(ratio, threshold, std::min(8.0f * threshold, 1.0f));
}

// x^b for x in [0, 1]. The usual whole exponents are multiplied out.
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

// What one feature contributes to one cell.
struct Share {
    int node;
    float height;
    float weight;
};

// The weights of eq. 3.7. They are divided by the approximate height, which cancels in
// the sum and keeps any bias within the range of floats. They fade towards the border
// where the pass stops, so that it leaves no seam (docs/papers.md, Rusnell 5).
class Weights {
  public:
    Weights(const Ground& ground, const Halting& halting, const BlendOptions& options,
            const std::vector<float>& approximate)
        : ground_(ground),
          halting_(halting),
          approximate_(approximate),
          power_(options.bias) {
        if (options.bias_map.empty()) return;
        biases_.resize(approximate.size());
        for (int y = 0; y < ground.graph.height; ++y)
            for (int x = 0; x < ground.graph.width; ++x)
                biases_[ground.graph.node(x, y)] = options.bias_map(x, y);
    }

    std::vector<Share> shares(int feature, const Pass& pass) const {
        const int group = ground_.features.features[feature].group;
        std::vector<Share> shares;
        shares.reserve(pass.nodes.size());
        for (std::size_t i = 0; i < pass.nodes.size(); ++i) {
            const float height = pass.heights[i];
            const float weight = weight_of(pass.nodes[i], height, group);
            if (weight > 0.0f) shares.push_back({pass.nodes[i], height, weight});
        }
        return shares;
    }

  private:
    float weight_of(int node, float height, int group) const {
        if (halting_.at_sea(height)) return 0.0f;
        const float ratio = std::min(1.0f, height / approximate_[node]);
        const float biased =
            biases_.empty() ? power_(ratio) : std::pow(ratio, biases_[node]);
        return fade_at_sea(height, halting_.sea_level_threshold) *
               fade_below(ratio, halting_.approximate_threshold) * biased *
               ground_.regions.admission(node, group);
    }

    const Ground& ground_;
    const Halting& halting_;
    const std::vector<float>& approximate_;
    std::vector<float> biases_;  // by node; empty: the same everywhere
    Power power_;
};

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
    // Eq. 3.7, by node. The land also fades where the last feature stops, so that it
    // meets the sea without a step.
    std::vector<float> blended(float least) const {
        std::vector<float> result(heights.size());
        for (std::size_t node = 0; node < result.size(); ++node) {
            if (weights[node] <= 0.0f) continue;
            result[node] =
                fade_at_sea(highest[node], least) * (heights[node] / weights[node]);
        }
        return result;
    }
};

struct Work {
    const Ground& ground;
    const Halting& halting;
    const std::vector<float>& approximate;
    const Weights& weights;
    const Observers& observers;
};

// A feature in the pipeline.
struct Ticket {
    int feature = 0;
    Pass pass;
    std::vector<Share> shares;

    void go(const Work& work, LeastCost& paths) {
        const PassMemory* memory = work.observers.memory;
        auto known =
            memory ? memory->recalled(feature, work.approximate, paths) : std::nullopt;
        pass = known ? std::move(*known)
                     : pass_of(feature, work.ground, work.halting, work.approximate,
                               paths, memory ? Keep::kLabels : Keep::kHeights);
        shares = work.weights.shares(feature, pass);
    }
};

// Step 7 for every feature in parallel. The sums are taken in the features' order.
void sum_features(const Work& work, int threads, Sums& sums, Progress& progress,
                  PassCounts& counts) {
    // Labels stay with their thread: on another one they would have to move between the
    // processors' caches.
    tbb::enumerable_thread_specific<LeastCost> paths(
        [&] { return LeastCost(work.ground.graph); });
    const int count = work.ground.features.count();
    int next = 0;
    const auto take = [&](tbb::flow_control& control) {
        auto ticket = std::make_shared<Ticket>();
        if (next == count) {
            control.stop();
            return ticket;
        }
        ticket->feature = next++;
        return ticket;
    };
    const auto go = [&](std::shared_ptr<Ticket> ticket) {
        ticket->go(work, paths.local());
        return ticket;
    };
    const auto add = [&](const std::shared_ptr<Ticket>& ticket) {
        sums.add(ticket->shares);
        const Pass& pass = ticket->pass;
        counts.features += pass.nodes.size();
        counts.recalled += pass.nodes.size() - std::min(pass.settled, pass.nodes.size());
        if (Explainer* explainer = work.observers.explainer) {
            explainer->pass(ticket->feature, pass);
        }
        if (PassMemory* memory = work.observers.memory) {
            memory->keep(ticket->feature, pass, work.approximate);
        }
        progress.report((ticket->feature + 1.0) / count);
    };
    using tbb::filter_mode;
    using Passed = std::shared_ptr<Ticket>;
    tbb::parallel_pipeline(
        static_cast<std::size_t>(threads) + 1,
        tbb::make_filter<void, Passed>(filter_mode::serial_in_order, take) &
            tbb::make_filter<Passed, Passed>(filter_mode::parallel, go) &
            tbb::make_filter<Passed, void>(filter_mode::serial_in_order, add));
}

int threads_for(double cells) {
    const int fit = static_cast<int>(
        std::clamp(kLabelBytes / (cells * sizeof(Label)), 1.0, 1.0 * kMaxThreads));
    return std::min(fit, tbb::this_task_arena::max_concurrency());
}

}  // namespace

Field<float> by_sample(const Graph& graph, const std::vector<float>& values) {
    Field<float> field(graph.width, graph.height);
    for (int y = 0; y < graph.height; ++y)
        for (int x = 0; x < graph.width; ++x) field(x, y) = values[graph.node(x, y)];
    return field;
}

Field<float> blended_heights(const Ground& ground, const Halting& halting,
                             const BlendOptions& options,
                             const std::vector<float>& approximate, Progress& progress,
                             const Observers& observers, PassCounts* counts) {
    const Weights weights(ground, halting, options, approximate);
    const Work work{ground, halting, approximate, weights, observers};
    PassCounts counted;
    Sums sums(ground.graph.nodes());
    const int threads = threads_for(ground.graph.nodes());
    tbb::task_arena(threads).execute(
        [&] { sum_features(work, threads, sums, progress, counted); });
    if (counts) *counts = counted;
    return by_sample(ground.graph, sums.blended(halting.sea_level_threshold));
}

double blend_bytes(double cells) {
    const double pass = sizeof(Label) + 2 * sizeof(int) + sizeof(float) + sizeof(Share);
    return cells * (pass * threads_for(cells) + 5.0 * sizeof(float));
}

}  // namespace cydonia::distance
