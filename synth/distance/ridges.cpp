// B. Rusnell, "Distance-based terrain synthesis" (2009), sections 4.1 and 5.4.

#include "synth/distance/ridges.h"

#include <numeric>
#include <optional>

#include "field/error.h"
#include "field/random.h"
#include "synth/distance/cost_model.h"
#include "synth/distance/dijkstra.h"

namespace cydonia::distance {
namespace {

constexpr int kTries = 10000;  // of a ridge

std::vector<int> groups_named(const Ridges& ridges,
                              const std::vector<PlacedGroup>& groups) {
    if (ridges.from.empty()) return {static_cast<int>(groups.size()) - 1};
    std::vector<int> which;
    for (const std::string& name : ridges.from) {
        const PlacedGroup& named =
            group_before(groups, name, "group '" + groups.back().name + "': ridges.from");
        which.push_back(static_cast<int>(&named - groups.data()));
    }
    return which;
}

void check(const Ridges& ridges, const std::string& name, double width) {
    if (ridges.count < 0) {
        throw bad_request("group '{}': ridges.count is {}: it must be at least 0", name,
                          ridges.count);
    }
    if (!(ridges.cost_factor >= 0.0)) {
        throw bad_request("group '{}': ridges.cost_factor is {}: it must be at least 0",
                          name, ridges.cost_factor);
    }
    if (ridges.reach && !(ridges.reach->in(width) > 0.0)) {
        throw bad_request("group '{}': ridges.reach is {} m: it must be above 0", name,
                          ridges.reach->in(width));
    }
}

// Grows ridges on the layout, where paths are the same at every resolution.
class Growing {
  public:
    Growing(const Ridges& ridges, std::vector<PlacedGroup>& groups, const Site& site)
        : ridges_(ridges),
          groups_(groups),
          site_(site),
          layout_(site.layout()),
          origins_(origins_of(groups_named(ridges, groups), groups, layout_)),
          reach_(ridges.reach ? std::optional(ridges.reach->in(site.width))
                              : std::nullopt),
          generators_(reach_.value_or(site.width)),
          paths_(layout_),
          on_ridge_(static_cast<std::size_t>(layout_.nodes())) {
        if (origins_.starts.empty()) {
            throw bad_request(
                "group '{}': there is no feature for its ridges to grow from",
                groups.back().name);
        }
        paths_.spread(origins_.starts, RawCostModel{origins_.starts});
        if (!reach_) return;
        for (const Origins::Origin& o : origins_.of) {
            const SitePoint& p = groups[o.group].shapes[o.shape].places[o.place];
            generators_.add(p.x, p.y, 0);
        }
    }

    void grow(int k) {
        const std::string& name = groups_.back().name;
        for (int j = 0; j < kTries; ++j) {
            const std::uint64_t h =
                hash_of({site_.seed, key("ridge"), key_of(name),
                         static_cast<std::uint64_t>(k), static_cast<std::uint64_t>(j)});
            const double x = unit(mix(h ^ 1)) * site_.width;
            const double y = unit(mix(h ^ 2)) * site_.depth;
            const int node = node_at(layout_, x, y);
            const bool taken = on_ridge_[node] || paths_[node].direction == Label::kStart;
            if (taken || (reach_ && !generators_.any_within(x, y, *reach_))) continue;
            return trace_back(node);
        }
        throw bad_request(
            "group '{}': found a node for {} of {} ridges: lower ridges.count or raise "
            "ridges.reach",
            name, k, ridges_.count);
    }

  private:
    // Paths of one pass that meet continue as one.
    void trace_back(int end) {
        const Origins::Origin& origin = origins_.of[paths_[end].origin];
        Shape& shape = groups_[origin.group].shapes[origin.shape];
        const int root = root_of(end, shape, shape.places[origin.place].root);
        SitePoint before = place_of(end, root);
        shape.places.push_back(before);
        shape.land.push_back(before);
        for (int node = end;
             !on_ridge_[node] && paths_[node].direction != Label::kStart;) {
            on_ridge_[node] = true;
            node -= layout_.step[paths_[node].direction];
            const SitePoint here = place_of(node, root);
            // Where the land's grid is finer than the layout, places between its nodes
            // close the gaps.
            append_line(shape.land, before, here, site_.graph.spacing);
            shape.places.push_back(here);
            before = here;
        }
    }

    // A ridge on the side of the feature's first profile has that profile on all sides,
    // and no root. On the other side its places divide the ground as the stroke does from
    // which it grows.
    int root_of(int end, const Shape& shape, int origin) const {
        if (shape.sides.empty() || origin < 0) return origin;
        const auto [x, y] = shape.sides[origin];
        const SitePoint foot = shape.places[origin], tip = site_.centre_of(layout_, end);
        return x * (tip.x - foot.x) + y * (tip.y - foot.y) >= 0.0f ? -1 : origin;
    }

    SitePoint place_of(int node, int root) const {
        SitePoint place = site_.centre_of(layout_, node);
        place.cost = static_cast<float>(ridges_.cost_factor) * paths_[node].cost;
        place.root = root;
        return place;
    }

    const Ridges& ridges_;
    std::vector<PlacedGroup>& groups_;
    const Site& site_;
    const Graph& layout_;
    Origins origins_;
    std::optional<double> reach_;
    PointIndex generators_;
    LeastCost paths_;
    std::vector<bool> on_ridge_;
};

}  // namespace

Origins origins_of(std::span<const int> which, const std::vector<PlacedGroup>& groups,
                   const Graph& graph) {
    Origins origins;
    for (int g : which) {
        for (std::size_t s = 0; s < groups[g].shapes.size(); ++s) {
            const std::vector<SitePoint>& places = groups[g].shapes[s].places;
            for (std::size_t p = 0; p < places.size(); ++p) {
                origins.starts.push_back(
                    {node_at(graph, places[p].x, places[p].y), places[p].cost});
                origins.of.push_back({g, static_cast<int>(s), static_cast<int>(p)});
            }
        }
    }
    return origins;
}

void grow_ridges(const Ridges& ridges, std::vector<PlacedGroup>& groups,
                 const Site& site) {
    check(ridges, groups.back().name, site.width);
    if (ridges.count == 0) return;
    Growing growing(ridges, groups, site);
    for (int k = 0; k < ridges.count; ++k) growing.grow(k);
}

}  // namespace cydonia::distance
