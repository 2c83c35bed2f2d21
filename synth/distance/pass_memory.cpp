#include "synth/distance/pass_memory.h"

#include <xxhash.h>

#include <type_traits>

#include "field/archive.h"

namespace cydonia::distance {
namespace {

constexpr std::string_view kKind = "cydonia passes 3\n";
constexpr std::size_t kMostKeptBytes = std::size_t{256} << 20;

class Hash {
  public:
    template <class T>
    void add(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        add(&value, sizeof value);
    }
    template <class T>
    void add_all(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        add(values.size());
        if (!values.empty()) add(values.data(), values.size_bytes());
    }
    std::uint64_t result() const { return state_; }

  private:
    void add(const void* bytes, std::size_t count) {
        state_ = XXH3_64bits_withSeed(bytes, count, state_);
    }
    std::uint64_t state_ = 0;
};

// A hash of everything that all passes depend on.
std::uint64_t key_of_ground(const Ground& ground, const Halting& halting) {
    Hash hash;
    const Graph& graph = ground.graph;
    hash.add(graph.stride);
    hash.add(graph.directions);
    hash.add_all(std::span(graph.weights));
    const Shapes& shapes = ground.shapes;
    hash.add(shapes.sea_level);
    hash.add(shapes.mean_edge_weight);
    for (const Descent& descent : shapes.descents) {
        hash.add_all(std::span(descent.knots));
    }
    hash.add_all(std::span(shapes.way_at));
    hash.add(halting.sea_level_threshold);
    hash.add(halting.approximate_threshold);
    return hash.result();
}

}  // namespace

// The archive is the key of the ground, then for each feature its key and its record.
PassMemory::PassMemory(const Ground& ground, const Halting& halting, std::string bytes)
    : ground_(ground),
      halting_(halting),
      ground_key_(key_of_ground(ground, halting)),
      known_bytes_(std::move(bytes)) {
    if (const auto body = unsealed(known_bytes_, kKind)) index_known(*body);
    ArchiveWriter(kept_).value(ground_key_);
}

void PassMemory::index_known(std::string_view body) {
    using Records = std::map<std::uint64_t, std::string_view>;
    const auto records = read_back(body, [&](ArchiveReader& in) {
        ArchiveReader::expect(in.value<std::uint64_t>() == ground_key_);
        Records known;
        while (!in.at_end()) {
            const auto key = in.value<std::uint64_t>();
            known.emplace(key, in.text_view());
        }
        return known;
    });
    known_ = records.value_or(Records{});
}

std::uint64_t PassMemory::key_of(int feature) const {
    Hash hash;
    hash.add_all(ground_.features.of(feature));
    const auto first = static_cast<std::size_t>(ground_.features.first[feature]);
    const std::size_t count = ground_.features.of(feature).size();
    const auto of_starts = [&](const auto& values) {
        if (!values.empty()) hash.add_all(std::span(values).subspan(first, count));
    };
    of_starts(ground_.shapes.ways);
    of_starts(ground_.shapes.other_ways);
    if (!ground_.shapes.beside.empty()) {
        hash.add_all(std::span<const std::uint8_t>(own_sides(feature)));
    }
    return hash.result();
}

// The sides that the feature's own strokes give to the nodes beside them.
std::vector<std::uint8_t> PassMemory::own_sides(int feature) const {
    constexpr std::uint8_t kNone = 2;
    const Graph& graph = ground_.graph;
    const Shapes& shapes = ground_.shapes;
    std::vector<std::uint8_t> sides;
    for (const Start& start : ground_.features.of(feature)) {
        const int x0 = graph.x_of(start.node), y0 = graph.y_of(start.node);
        for (int y = y0 - Shapes::kBeside; y <= y0 + Shapes::kBeside; ++y) {
            for (int x = x0 - Shapes::kBeside; x <= x0 + Shapes::kBeside; ++x) {
                if (x < 0 || y < 0 || x >= graph.width || y >= graph.height) continue;
                const int node = graph.node(x, y);
                const bool own = shapes.beside[node] == feature;
                sides.push_back(own ? shapes.side_at[node] : kNone);
            }
        }
    }
    return sides;
}

// A record holds the nodes of a pass, each with whether the pass went on there in its
// lowest bit, and their labels.
std::optional<LeastCost::Trace> PassMemory::trace_of(int feature) const {
    const auto record = known_.find(key_of(feature));
    if (record == known_.end()) return std::nullopt;
    const Graph& graph = ground_.graph;
    const int first = graph.node(0, 0);
    const int last = graph.node(graph.width - 1, graph.height - 1);
    const std::size_t starts = ground_.features.of(feature).size();
    return read_back(record->second, [&](ArchiveReader& in) {
        LeastCost::Trace trace;
        for (const std::uint32_t word : in.vector<std::uint32_t>()) {
            trace.nodes.push_back(static_cast<int>(word >> 1));
            trace.expanded.push_back(word & 1);
        }
        trace.labels = in.vector<Label>();
        ArchiveReader::expect(trace.labels.size() == trace.nodes.size());
        for (const int node : trace.nodes)
            ArchiveReader::expect(node >= first && node <= last);
        for (const Label& label : trace.labels)
            ArchiveReader::expect(
                static_cast<std::size_t>(label.origin) < starts &&
                (label.direction == Label::kStart || label.direction < graph.directions));
        return trace;
    });
}

std::optional<Pass> PassMemory::recalled(int feature, std::span<const float> approximate,
                                         LeastCost& paths) const {
    auto trace = trace_of(feature);
    if (!trace) return std::nullopt;
    Pass pass{std::move(trace->nodes), {}, std::move(trace->labels), 0};
    bool same = true;
    for (std::size_t i = 0; i < pass.nodes.size(); ++i) {
        pass.heights.push_back(height_of(pass.labels[i].cost, ground_.shapes));
        const bool goes_on =
            halting_.goes_on(pass.heights[i], approximate[pass.nodes[i]]);
        same = same && goes_on == static_cast<bool>(trace->expanded[i]);
    }
    if (same) return pass;
    trace->nodes = std::move(pass.nodes);
    trace->labels = std::move(pass.labels);
    return pass_again(feature, ground_, halting_, approximate, *trace, paths);
}

void PassMemory::keep(int feature, const Pass& pass, std::span<const float> approximate) {
    const std::size_t count = pass.nodes.size();
    const std::size_t bytes = count * (sizeof(std::uint32_t) + sizeof(Label));
    overflowed_ = overflowed_ || kept_.size() + bytes > kMostKeptBytes;
    if (overflowed_) {
        kept_ = {};
        return;
    }
    std::vector<std::uint32_t> words(count);
    for (std::size_t i = 0; i < count; ++i) {
        const int node = pass.nodes[i];
        const bool goes_on = halting_.goes_on(pass.heights[i], approximate[node]);
        words[i] = static_cast<std::uint32_t>(node) << 1 | (goes_on ? 1u : 0u);
    }
    ArchiveWriter out(kept_);
    out.value(key_of(feature));
    out.text(archive_of([&](ArchiveWriter& record) {
        record.vector(words);
        record.vector(pass.labels);
    }));
}

std::string PassMemory::taken_bytes() {
    return overflowed_ ? std::string() : sealed(kKind, std::move(kept_));
}

}  // namespace cydonia::distance
