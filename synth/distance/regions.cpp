// B. Rusnell, "Distance-based terrain synthesis" (2009), sections 4.2.1 and 4.2.5.

#include "synth/distance/regions.h"

#include <algorithm>

#include "field/cells_inside.h"
#include "field/enclosed.h"
#include "field/error.h"
#include "field/strokes.h"

namespace cydonia::distance {
namespace {

// A mask that is 1 where the image is drawn. It is grey, so that soft edges stay soft.
Field<float> drawn(const Source& image, const Graph& graph) {
    Field<float> mask = read_grey_at(image, graph.width, graph.height);
    for (float& value : mask) value = 1.0f - value;
    return mask;
}

// The distance in cells from the outside, where it is 0.
Field<float> depth_inside(const Field<float>& mask) {
    Field<std::uint8_t> inside(mask.width(), mask.height());
    std::ranges::transform(mask, inside.begin(), [](float m) { return m >= 0.5f; });
    return cells_inside(inside, true);
}

Field<float> mask_of(const RegionOptions& region, const Options& options,
                     const Graph& graph, const Features& features) {
    if (region.image) return drawn(*region.image, graph);
    const auto group = std::ranges::find(options.groups, region.inside, &Group::name);
    const Field<std::uint8_t> inside =
        enclosed(graph, features, static_cast<int>(group - options.groups.begin()));
    Field<float> mask(graph.width, graph.height);
    std::ranges::copy(inside, mask.begin());
    if (std::ranges::count(inside, 1) == 0) {
        throw bad_request(
            "region: the strokes of group '{}' enclose nothing; close them, or draw the "
            "region as an image",
            region.inside);
    }
    return mask;
}

std::uint64_t groups_named(const std::vector<std::string>& names,
                           const Options& options) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < options.groups.size(); ++i) {
        if (std::ranges::find(names, options.groups[i].name) != names.end()) {
            bits |= std::uint64_t{1} << i;
        }
    }
    return bits;
}

void close_to_others(Regions& regions, const RegionOptions& region,
                     const Field<float>& mask, std::uint8_t index, const Graph& graph) {
    const double width = graph.width * graph.spacing;
    const auto feather =
        static_cast<float>(std::max(region.feather.in(width) / graph.spacing, 1.0));
    const Field<float> depth = depth_inside(mask);
    for (int y = 0; y < graph.height; ++y) {
        for (int x = 0; x < graph.width; ++x) {
            if (mask(x, y) < 0.5f) continue;
            const int node = graph.node(x, y);
            regions.closed_by[node] = index;
            regions.closed[node] = std::min(1.0f, depth(x, y) / feather);
        }
    }
}

}  // namespace

Regions regions_of(const Options& options, const Graph& graph, const Features& features) {
    Regions regions;
    const auto nodes = static_cast<std::size_t>(graph.nodes());
    for (std::size_t i = 0; i < options.regions.size(); ++i) {
        const RegionOptions& region = options.regions[i];
        const Field<float> mask = mask_of(region, options, graph, features);
        if (!region.profile.empty()) {
            regions.profile_at.resize(nodes, Regions::kFree);
            const auto profile =
                std::ranges::find(options.profiles, region.profile, &Profile::name);
            for (int y = 0; y < graph.height; ++y) {
                for (int x = 0; x < graph.width; ++x) {
                    if (mask(x, y) < 0.5f) continue;
                    regions.profile_at[graph.node(x, y)] =
                        static_cast<std::uint8_t>(profile - options.profiles.begin());
                }
            }
        }
        regions.open_to.push_back(groups_named(region.only, options));
        if (region.only.empty()) continue;
        regions.closed_by.resize(nodes);
        regions.closed.resize(nodes);
        close_to_others(regions, region, mask, static_cast<std::uint8_t>(i), graph);
    }
    return regions;
}

Field<std::uint8_t> enclosed(const Graph& graph, const Features& features, int group) {
    Field<std::uint8_t> strokes(graph.width, graph.height);
    for (int f = 0; f < features.count(); ++f) {
        if (features.features[f].group != group) continue;
        for (const Start& start : features.of(f)) {
            strokes(graph.x_of(start.node), graph.y_of(start.node)) = 1;
        }
    }
    return enclosed_by(strokes);
}

}  // namespace cydonia::distance
