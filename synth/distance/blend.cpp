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

// Calls use(growth) with the growth of cost from some of the starts: `first` on.
template <class Use>
void with_growth(const Ground& ground, std::span<const Start> starts, int first,
                 const Use& use) {
    const Shapes& shapes = ground.shapes;
    if (shapes.raw()) return use(RawGrowth{starts});
    if (shapes.plain()) return use(ProfileGrowth(shapes, starts, first));
    use(ChangingGrowth(ground.graph, shapes, starts, first));
}

struct Work {
    const Ground& ground;
    const BlendOptions& options;
    std::vector<float> approximate;  // heights by node, 0 where no feature comes
    float sea_level, least, part;
    std::vector<float> biases;  // by node; empty: options.bias
    Power power;

    Work(const Ground& all, const BlendOptions& how, const std::vector<float>& costs)
        : ground(all),
          options(how),
          approximate(costs.size()),
          sea_level(static_cast<float>(all.shapes.sea_level)),
          least(static_cast<float>(how.sea_level_threshold)),
          part(static_cast<float>(how.approximate_threshold)),
          power(how.bias) {
        for (std::size_t i = 0; i < costs.size(); ++i)
            approximate[i] = height_at(costs[i]);
        if (how.bias_map.empty()) return;
        biases.resize(costs.size());
        for (int y = 0; y < all.graph.height; ++y)
            for (int x = 0; x < all.graph.width; ++x)
                biases[all.graph.node(x, y)] = how.bias_map(x, y);
    }
    float height_at(float cost) const {  // eq. 3.2
        return std::max(0.0f, sea_level - cost);
    }
    float biased(float ratio, int node) const {
        return biases.empty() ? power(ratio) : std::pow(ratio, biases[node]);
    }
};

// Step 7a, and the weights of eq. 3.7. They are relative to the approximate height, which
// cancels in the sum and keeps any bias within range, and fade towards the border where
// the pass stops, so that it leaves no seam (notes.md, Rusnell 5).
std::vector<Share> shares_of(const Work& work, int feature, LeastCost& paths) {
    const Features& features = work.ground.features;
    const std::span<const Start> starts = features.of(feature);
    const auto expand = [&](int node, float cost) {
        const float height = work.height_at(cost);
        return height > work.least && height > work.part * work.approximate[node];
    };
    with_growth(work.ground, starts, features.first[feature],
                [&](const auto& growth) { paths.spread(starts, growth, expand); });

    const int group = features.features[feature].group;
    std::vector<Share> shares;
    shares.reserve(paths.settled().size());
    for (int node : paths.settled()) {
        const float height = work.height_at(paths[node].cost);
        if (!(height > work.least)) continue;
        const float ratio = std::min(1.0f, height / work.approximate[node]);
        const float weight = fade_at_sea(height, work.least) *
                             fade_below(ratio, work.part) * work.biased(ratio, node) *
                             work.ground.regions.admission(node, group);
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
    const int count = work.ground.features.count();
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

template <class Value>
Field<float> by_sample(const Graph& graph, const Value& value) {
    Field<float> field(graph.width, graph.height);
    for (int y = 0; y < graph.height; ++y)
        for (int x = 0; x < graph.width; ++x) field(x, y) = value(graph.node(x, y));
    return field;
}

// The starts of the groups that a region is open to, and their ways, as a ground of their
// own.
struct Part {
    Features features;
    Shapes shapes;
};

Part part_open(const Ground& ground, std::uint64_t open_to) {
    Part part{{}, ground.shapes};
    const Features& all = ground.features;
    part.shapes.ways.clear();
    part.shapes.other_ways.clear();
    part.shapes.sides.clear();
    const auto keep = [](const auto& from, auto& to, int i) {
        if (!from.empty()) to.push_back(from[i]);
    };
    for (int f = 0; f < all.count(); ++f) {
        if (!(open_to >> all.features[f].group & 1)) continue;
        for (int i = all.first[f]; i < all.first[f + 1]; ++i) {
            part.features.starts.push_back(all.starts[i]);
            keep(ground.shapes.ways, part.shapes.ways, i);
            keep(ground.shapes.other_ways, part.shapes.other_ways, i);
            keep(ground.shapes.sides, part.shapes.sides, i);
        }
    }
    return part;
}

void spread_all(const Ground& ground, float least, LeastCost& paths) {
    const std::span<const Start> starts = ground.features.starts;
    const auto sea_level = static_cast<float>(ground.shapes.sea_level);
    with_growth(ground, starts, 0, [&](const auto& growth) {
        paths.spread(starts, growth,
                     [&](int, float cost) { return sea_level - cost > least; });
    });
}

}  // namespace

std::vector<float> approximate_costs(const Ground& ground, const BlendOptions& options) {
    const auto least = static_cast<float>(options.sea_level_threshold);
    LeastCost paths(ground.graph);
    spread_all(ground, least, paths);
    std::vector<float> costs(static_cast<std::size_t>(ground.graph.nodes()), kUnreached);
    for (int node : paths.settled()) costs[node] = paths[node].cost;
    const auto sea_level = static_cast<float>(ground.shapes.sea_level);

    // In a region that is closed to some, the others make the land alone.
    const Regions& regions = ground.regions;
    for (std::size_t i = 0; i < regions.open_to.size(); ++i) {
        if (regions.open_to[i] == 0) continue;
        const Part part = part_open(ground, regions.open_to[i]);
        spread_all({ground.graph, part.features, part.shapes, regions}, least, paths);
        for (std::size_t node = 0; node < costs.size(); ++node) {
            if (regions.closed[node] == 0.0f || regions.closed_by[node] != i) continue;
            const float here = paths[static_cast<int>(node)].cost;
            costs[node] = std::lerp(std::min(costs[node], sea_level),
                                    std::min(here, sea_level), regions.closed[node]);
        }
    }
    return costs;
}

Field<float> blended_heights(const Ground& ground, const BlendOptions& options,
                             const std::vector<float>& costs, Progress& progress,
                             PassCounts* counts) {
    const Work work(ground, options, costs);
    PassCounts counted;
    counted.approximate = static_cast<std::size_t>(
        std::ranges::count_if(costs, [](float cost) { return cost < kUnreached; }));
    std::vector<std::unique_ptr<LeastCost>> passes(static_cast<std::size_t>(
        std::min(passes_at_once(ground.graph.nodes()), ground.features.count())));
    for (auto& paths : passes) paths = std::make_unique<LeastCost>(ground.graph);

    Sums sums(ground.graph.nodes());
    sum_features(work, passes, sums, progress, counted);
    if (counts) *counts = counted;
    return by_sample(ground.graph,
                     [&](int node) { return sums.height_at(node, work.least); });
}

Field<float> approximate_heights(const Ground& ground, const std::vector<float>& costs) {
    const auto sea_level = static_cast<float>(ground.shapes.sea_level);
    return by_sample(ground.graph,
                     [&](int node) { return std::max(0.0f, sea_level - costs[node]); });
}

double blend_bytes(double cells) {
    const double pass = sizeof(Label) + sizeof(int) + sizeof(Share);
    return cells * (pass * passes_at_once(cells) + 5.0 * sizeof(float));
}

}  // namespace cydonia::distance
