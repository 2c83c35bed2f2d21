#include "synth/distance/pass_memory.h"

#include <xxhash.h>

#include <cstring>
#include <type_traits>

namespace cydonia::distance {
namespace {

constexpr std::string_view kMagic = "cydonia passes 2\n";
constexpr std::size_t kMostBytes = std::size_t{256} << 20;

template <class T>
void append(std::string& to, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
void append_all(std::string& to, const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    to.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

template <class T>
T value_at(std::string_view bytes, std::size_t place) {
    T value;
    std::memcpy(&value, bytes.data() + place, sizeof value);
    return value;
}

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

// Magic, key of the ground, checksum of what follows.
constexpr std::size_t kHead = kMagic.size() + 2 * sizeof(std::uint64_t);

// What all passes depend on.
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

// A feature's record: key, count, then its nodes - whether the pass went on there in the
// lowest bit - and its labels.
constexpr std::size_t kRecordHead = sizeof(std::uint64_t) + sizeof(std::uint32_t);
constexpr std::size_t kBytesANode = sizeof(std::uint32_t) + sizeof(Label);

}  // namespace

PassMemory::PassMemory(const Ground& ground, const Halting& halting, std::string bytes)
    : ground_(ground),
      halting_(halting),
      ground_key_(key_of_ground(ground, halting)),
      known_bytes_(std::move(bytes)),
      kept_(kMagic) {
    append(kept_, ground_key_);
    append(kept_, std::uint64_t{0});
    index_known();
}

void PassMemory::index_known() {
    std::string_view left = known_bytes_;
    if (!left.starts_with(kMagic)) return;
    left.remove_prefix(kMagic.size());
    if (left.size() < 2 * sizeof(std::uint64_t)) return;
    const auto ground = value_at<std::uint64_t>(left, 0);
    const auto checksum = value_at<std::uint64_t>(left, sizeof ground);
    left.remove_prefix(2 * sizeof(std::uint64_t));
    if (ground != ground_key_ || checksum != XXH3_64bits(left.data(), left.size()))
        return;
    while (left.size() >= kRecordHead) {
        const std::size_t size =
            kRecordHead +
            kBytesANode * value_at<std::uint32_t>(left, sizeof(std::uint64_t));
        if (left.size() < size) return;
        known_.emplace(value_at<std::uint64_t>(left, 0), left.substr(0, size));
        left.remove_prefix(size);
    }
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

// The sides that the feature's own strokes give the nodes beside them.
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

std::optional<LeastCost::Trace> PassMemory::trace_of(int feature) const {
    const auto record = known_.find(key_of(feature));
    if (record == known_.end()) return std::nullopt;
    const std::string_view bytes = record->second.substr(kRecordHead);
    const std::size_t count = bytes.size() / kBytesANode;
    LeastCost::Trace trace{std::vector<int>(count), std::vector<Label>(count),
                           std::vector<std::uint8_t>(count)};
    std::memcpy(trace.labels.data(), bytes.data() + count * sizeof(std::uint32_t),
                count * sizeof(Label));
    const Graph& graph = ground_.graph;
    const int first = graph.node(0, 0);
    const int last = graph.node(graph.width - 1, graph.height - 1);
    const std::size_t starts = ground_.features.of(feature).size();
    for (std::size_t i = 0; i < count; ++i) {
        const auto word = value_at<std::uint32_t>(bytes, i * sizeof(std::uint32_t));
        trace.nodes[i] = static_cast<int>(word >> 1);
        trace.expanded[i] = word & 1;
        const Label& label = trace.labels[i];
        const bool sound =
            trace.nodes[i] >= first && trace.nodes[i] <= last &&
            static_cast<std::size_t>(label.origin) < starts &&
            (label.direction == Label::kStart || label.direction < graph.directions);
        if (!sound) return std::nullopt;
    }
    return trace;
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
    overflowed_ = overflowed_ || kept_.size() + count * kBytesANode > kMostBytes;
    if (overflowed_) {
        kept_ = {};
        return;
    }
    append(kept_, key_of(feature));
    append(kept_, static_cast<std::uint32_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const int node = pass.nodes[i];
        const bool goes_on = halting_.goes_on(pass.heights[i], approximate[node]);
        append(kept_, static_cast<std::uint32_t>(node) << 1 | (goes_on ? 1u : 0u));
    }
    append_all(kept_, pass.labels);
}

std::string PassMemory::taken_bytes() {
    if (overflowed_) return {};
    const std::string_view records = std::string_view(kept_).substr(kHead);
    const std::uint64_t checksum = XXH3_64bits(records.data(), records.size());
    std::memcpy(kept_.data() + kHead - sizeof checksum, &checksum, sizeof checksum);
    return std::move(kept_);
}

}  // namespace cydonia::distance
