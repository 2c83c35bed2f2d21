// B. Rusnell, "Distance-based terrain synthesis" (2009), section 3.3, step 2.

#include "synth/distance/features.h"

#include <algorithm>
#include <memory>
#include <numeric>

#include "field/error.h"
#include "synth/distance/cost_model.h"
#include "synth/distance/costs.h"
#include "synth/distance/places.h"
#include "synth/distance/ridges.h"
#include "synth/distance/sides.h"
#include "synth/distance/site.h"
#include "synth/distance/sources.h"

namespace cydonia::distance {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};

std::vector<Shape> shapes_of(const Group& group, const Site& site,
                             const DrawnStrokes& drawn,
                             const std::vector<PlacedGroup>& before) {
    const std::string& name = group.name;
    return std::visit(
        Overloaded{
            [&](const Strokes& strokes) { return drawn.of(strokes, name); },
            [&](const Peaks& peaks) { return peak_shapes(peaks, name, site, before); },
            [&](const Circles& circles) {
                return circle_shapes(circles, name, site, before);
            },
            [&](const Edges& edges) { return edge_shapes(edges, name, site); },
            [&](const Terraces& terraces) {
                return terrace_shapes(terraces, name, site);
            },
            [&](const Lip& lip) { return lip_shape(lip, name, site); }},
        group.where);
}

// Section 4.2.5: the approximate cost of the groups before under each feature, which is
// at most that of sea level.
class ApproximateCosts {
  public:
    ApproximateCosts(const std::vector<PlacedGroup>& before, const Site& site)
        : layout_(site.layout()), paths_(layout_) {
        std::vector<int> all(before.size());
        std::iota(all.begin(), all.end(), 0);
        const Origins origins = origins_of(all, before, layout_);
        paths_.spread(origins.starts, RawCostModel{origins.starts});
        for (const PlacedGroup& group : before) {
            sea_level_ =
                std::max(sea_level_, site.options.sea_level_scale * group.highest_cost());
        }
    }

    double mean_under(const Shape& shape) const {
        double sum = 0.0;
        for (const SitePoint& place : shape.places) {
            const double cost = paths_[node_at(layout_, place.x, place.y)].cost;
            sum += std::min(cost, sea_level_);
        }
        return sum / static_cast<double>(shape.places.size());
    }

  private:
    const Graph& layout_;
    LeastCost paths_;
    double sea_level_ = 0.0;
};

CostPattern::Reference reference_of(const Group& group, const Site& site,
                                    const std::vector<PlacedGroup>& before) {
    // Computed when a part of a rule first asks for it.
    const auto approximate = std::make_shared<std::unique_ptr<ApproximateCosts>>();
    return [&, approximate](const CostRule& rule, const Shape& shape) {
        const std::string asked = "group '" + group.name + "': share_of";
        if (rule.share_of != "approximate") {
            return group_before(before, rule.share_of, asked).highest_cost();
        }
        if (before.empty())
            throw bad_request("{} is approximate, and no group is before it", asked);
        if (!*approximate)
            *approximate = std::make_unique<ApproximateCosts>(before, site);
        return (*approximate)->mean_under(shape);
    };
}

int profile_index(const Options& options, const std::string& name,
                  const std::string& group) {
    const auto found = std::ranges::find(options.profiles, name, &Profile::name);
    if (found == options.profiles.end()) {
        throw bad_request("group '{}': no profile is named '{}'", group, name);
    }
    return static_cast<int>(found - options.profiles.begin());
}

// The length of a stroke over which its direction is averaged.
constexpr Length kDirectionReach = thesis_units(6.0);

// Collects starts: at each node one of each feature, with its least cost.
class Gathering {
  public:
    explicit Gathering(const Site& site)
        : site_(site), slots_(static_cast<std::size_t>(site.graph.nodes()), -1) {}

    void add(const Shape& shape, const Features::Feature& feature) {
        const int first = result.first.back();
        for (const SitePoint& place : shape.land) {
            const int node = node_at(site_.graph, place.x, place.y);
            int& slot = slots_[node];
            if (slot >= first) {
                Start& start = result.starts[slot];
                start.cost = std::min(start.cost, place.cost);
                continue;
            }
            slot = static_cast<int>(result.starts.size());
            result.starts.push_back({node, place.cost});
            if (!shape.sides.empty()) {
                result.sides.resize(result.starts.size());
                if (place.root >= 0) result.sides.back() = shape.sides[place.root];
            }
        }
        result.first.push_back(static_cast<int>(result.starts.size()));
        result.features.push_back(feature);
    }

    Features result;

  private:
    const Site& site_;
    std::vector<int> slots_;
};

void check_names(const Options& options) {
    for (std::size_t i = 0; i < options.groups.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (options.groups[i].name != options.groups[j].name) continue;
            throw bad_request("two groups are named '{}': give each its own name",
                              options.groups[i].name);
        }
    }
}

void add_sides(std::vector<Shape>& shapes, const Group& group, const Site& site) {
    if (std::holds_alternative<Peaks>(group.where) ||
        std::holds_alternative<Terraces>(group.where)) {
        throw bad_request("group '{}': other_side needs strokes, circles, edges or a lip",
                          group.name);
    }
    if (group.profile.empty()) {
        throw bad_request("group '{}': other_side needs a profile", group.name);
    }
    for (Shape& shape : shapes) {
        shape.sides = left_sides(shape, kDirectionReach.in(site.width));
    }
}

std::vector<PlacedGroup> placed_groups(const Site& site) {
    const DrawnStrokes drawn(site);
    NoiseRanges noises;
    std::vector<PlacedGroup> groups;
    for (const Group& group : site.options.groups) {
        std::vector<Shape> shapes = shapes_of(group, site, drawn, groups);
        if (!std::holds_alternative<Terraces>(group.where)) {
            set_costs(shapes, group, site, reference_of(group, site, groups), noises);
        }
        if (!group.other_side.empty()) add_sides(shapes, group, site);
        groups.push_back({group.name, std::move(shapes)});
        grow_ridges(group.ridges, groups, site);
    }
    return groups;
}

}  // namespace

Features features_of(const Options& options, const Graph& graph, const Terrain& terrain,
                     std::uint64_t seed) {
    check_names(options);
    const Site site(options, graph, terrain, seed);
    const std::vector<PlacedGroup> groups = placed_groups(site);
    Gathering gathering(site);
    for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
        const Group& group = options.groups[g];
        for (std::size_t i = 0; i < groups[g].shapes.size(); ++i) {
            const Shape& shape = groups[g].shapes[i];
            Features::Feature feature{.group = g};
            if (!group.profile.empty()) {
                feature.profile = profile_index(
                    options, group.profile[i % group.profile.size()], group.name);
            }
            if (!group.other_side.empty()) {
                feature.other_side = profile_index(options, group.other_side, group.name);
            }
            gathering.add(shape, feature);
        }
    }
    if (gathering.result.count() == 0) {
        throw bad_request("no features: give a group for the land to rise from");
    }
    if (!gathering.result.sides.empty()) {
        gathering.result.sides.resize(gathering.result.starts.size());
    }
    return std::move(gathering.result);
}

}  // namespace cydonia::distance
