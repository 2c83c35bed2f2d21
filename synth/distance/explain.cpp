#include "synth/distance/explain.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cydonia::distance {
namespace {

constexpr Rgb8 kGround{28, 28, 28};  // the dark ground around the generators
constexpr Rgb8 kNone{150, 150, 150};

std::uint8_t byte_of(double share) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

// A colour scale from black over red and yellow to white.
Rgb8 heat(double share) {
    return {byte_of(3.0 * share), byte_of(3.0 * share - 1.0), byte_of(3.0 * share - 2.0)};
}

Rgb8 darkened(const Rgb8& colour) {
    return {static_cast<std::uint8_t>(colour[0] / 3),
            static_cast<std::uint8_t>(colour[1] / 3),
            static_cast<std::uint8_t>(colour[2] / 3)};
}

Rgb8 colour_of_profile(int profile) {
    return profile < 0 ? kNone : distinct_colour(profile);
}

// A picture with colour(node) at every sample.
template <class Colour>
Field<Rgb8> picture_of(const Graph& graph, const Colour& colour) {
    Field<Rgb8> picture(graph.width, graph.height);
    for (int y = 0; y < graph.height; ++y)
        for (int x = 0; x < graph.width; ++x) picture(x, y) = colour(graph.node(x, y));
    return picture;
}

// Draws a sample so that it can be seen: three by three pixels, more in a large picture.
void dot(const Graph& graph, int node, const Rgb8& colour, Field<Rgb8>& picture) {
    const int reach = std::max(1, std::max(graph.width, graph.height) / 512);
    const int x = graph.x_of(node), y = graph.y_of(node);
    for (int j = y - reach; j <= y + reach; ++j)
        for (int i = x - reach; i <= x + reach; ++i)
            if (picture.contains(i, j)) picture(i, j) = colour;
}

// A picture with colour(feature, start) at every generator.
template <class Colour>
void dot_generators(const Ground& ground, const Colour& colour, Field<Rgb8>& picture) {
    for (int f = 0; f < ground.features.count(); ++f) {
        for (const Start& start : ground.features.of(f)) {
            dot(ground.graph, start.node, colour(f, start), picture);
        }
    }
}

// A text as a cell of comma-separated values.
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == text.npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

}  // namespace

// The hues are a golden section apart, and neighbours differ in brightness as well.
Rgb8 distinct_colour(int number) {
    constexpr double kBright[] = {1.0, 0.72, 0.86};
    const double turn = 0.6180339887498949 * number;
    const double hue = 6.0 * (turn - std::floor(turn));
    const double value = kBright[number % 3];
    const auto channel = [&](double peak) {
        const double away = std::abs(std::remainder(hue - peak, 6.0));
        return byte_of(value * (0.25 + 0.75 * std::clamp(2.0 - away, 0.0, 1.0)));
    };
    return {channel(0.0), channel(2.0), channel(4.0)};
}

Explainer::Explainer(const Explain& sinks, const Options& options, const Ground& ground,
                     const Halting& halting, const std::vector<float>& approximate)
    : sinks_(sinks),
      options_(options),
      ground_(ground),
      halting_(halting),
      approximate_(approximate),
      highest_(approximate.size(), -1),
      height_(approximate.size()),
      visits_(approximate.size()),
      table_(
          "feature,group,profile,generators,least_cost,mean_cost,searched,"
          "halted_at_sea,halted_far_below,halted_by_both\n") {
    show_generators();
    const float top = std::max(1e-6f, *std::ranges::max_element(approximate));
    sinks.picture("approximate", picture_of(ground.graph, [&](int node) {
                      const std::uint8_t grey = byte_of(approximate[node] / top);
                      return Rgb8{grey, grey, grey};
                  }));
}

void Explainer::show_generators() {
    const Graph& graph = ground_.graph;
    const Features& features = ground_.features;
    const auto empty = [&] { return Field<Rgb8>(graph.width, graph.height, kGround); };

    Field<Rgb8> ids = empty();
    dot_generators(
        ground_, [](int f, const Start&) { return distinct_colour(f); }, ids);
    sinks_.picture("features", ids);

    Field<Rgb8> profiles = picture_of(graph, [&](int node) {
        const auto& held = ground_.regions.profile_at;
        if (held.empty() || held[node] == Regions::kFree) return kGround;
        return darkened(distinct_colour(held[node]));
    });
    const auto profile = [&](int f, const Start&) {
        return colour_of_profile(features.features[f].profile);
    };
    dot_generators(ground_, profile, profiles);
    sinks_.picture("profiles", profiles);

    const double sea_level = std::max(1e-6, ground_.shapes.sea_level);
    Field<Rgb8> costs = empty();
    const auto cost = [&](int, const Start& start) {
        return heat(1.0 - 0.8 * start.cost / sea_level);
    };
    dot_generators(ground_, cost, costs);
    sinks_.picture("costs", costs);
}

void Explainer::pass(int feature, const Pass& pass) {
    for (std::size_t i = 0; i < pass.nodes.size(); ++i) {
        const int node = pass.nodes[i];
        ++visits_[node];
        if (!(pass.heights[i] > height_[node])) continue;
        height_[node] = pass.heights[i];
        highest_[node] = feature;
    }
    add_line(feature, pass);
    if (shown(feature)) show_search(feature, pass);
}

void Explainer::finish() {
    const std::uint32_t most = std::max(1u, *std::ranges::max_element(visits_));
    sinks_.picture("visits", picture_of(ground_.graph, [&](int node) {
                       return heat(1.0 * visits_[node] / most);
                   }));
    Field<Rgb8> highest = picture_of(ground_.graph, [&](int node) {
        return highest_[node] < 0 ? kElsewhere : distinct_colour(highest_[node]);
    });
    for (const Start& start : ground_.features.starts) {
        highest(ground_.graph.x_of(start.node), ground_.graph.y_of(start.node)) =
            kGenerator;
    }
    sinks_.picture("highest", highest);
    sinks_.table("features", table_);
}

// The features shown are spread evenly among all and include the first.
bool Explainer::shown(int feature) const {
    const int count = ground_.features.count();
    if (count <= kSearches) return true;
    const auto rank = [count](int f) {
        return static_cast<std::int64_t>(f) * kSearches / count;
    };
    return feature == 0 || rank(feature) != rank(feature - 1);
}

int Explainer::halt_of(int node, float height) const {
    // A feature is never below land that it made itself.
    const float land = approximate_[node];
    const bool below = height < land && halting_.far_below(height, land);
    return (halting_.at_sea(height) ? kSea : 0) | (below ? kBelow : 0);
}

void Explainer::show_search(int feature, const Pass& pass) {
    constexpr Rgb8 kColours[] = {kSearched, kAtSea, kFarBelow, kBoth};
    const Graph& graph = ground_.graph;
    Field<Rgb8> picture(graph.width, graph.height, kElsewhere);
    for (std::size_t i = 0; i < pass.nodes.size(); ++i) {
        const int node = pass.nodes[i];
        picture(graph.x_of(node), graph.y_of(node)) =
            kColours[halt_of(node, pass.heights[i])];
    }
    for (const Start& start : ground_.features.of(feature)) {
        picture(graph.x_of(start.node), graph.y_of(start.node)) = kGenerator;
    }
    sinks_.picture(fmt::format("search-{:05}", feature), picture);
}

void Explainer::add_line(int feature, const Pass& pass) {
    std::size_t halts[4] = {};
    for (std::size_t i = 0; i < pass.nodes.size(); ++i) {
        ++halts[halt_of(pass.nodes[i], pass.heights[i])];
    }
    const auto starts = ground_.features.of(feature);
    double least = starts.front().cost, sum = 0.0;
    for (const Start& start : starts) {
        least = std::min(least, 1.0 * start.cost);
        sum += start.cost;
    }
    const Features::Feature& own = ground_.features.features[feature];
    const std::string profile =
        own.profile < 0 ? "" : options_.profiles[own.profile].name;
    table_ +=
        fmt::format("{},{},{},{},{:.3f},{:.3f},{},{},{},{}\n", feature,
                    cell(name_of_group(own.group)), cell(profile), starts.size(), least,
                    sum / static_cast<double>(starts.size()), pass.nodes.size(),
                    halts[kSea], halts[kBelow], halts[kSea | kBelow]);
}

std::string Explainer::name_of_group(int group) const {
    const std::string& name = options_.groups[group].name;
    return name.empty() ? std::to_string(group) : name;
}

}  // namespace cydonia::distance
