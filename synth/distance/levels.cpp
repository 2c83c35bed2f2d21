// B. Rusnell, "Distance-based terrain synthesis" (2009), sections A.2.8 and A.2.9.

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/sample.h"
#include "field/strokes.h"
#include "synth/distance/cost_model.h"
#include "synth/distance/dijkstra.h"
#include "synth/distance/sources.h"

namespace cydonia::distance {
namespace {

// The path cost from drawn strokes at the nodes of the layout.
Field<float> costs_from(const Source& drawing, const Site& site) {
    const Field<Rgba8> cells = read_strokes(drawing, site.columns, site.rows);
    const Graph& layout = site.layout();
    std::vector<Start> starts;
    for (int y = 0; y < cells.height(); ++y) {
        for (int x = 0; x < cells.width(); ++x) {
            if (cells(x, y)[3] == 0) continue;
            starts.push_back({node_at(layout, (x + 0.5) / site.columns * site.width,
                                      (y + 0.5) / site.rows * site.depth),
                              0.0f});
        }
    }
    LeastCost paths(layout);
    paths.spread(starts, RawCostModel{starts});
    Field<float> costs(layout.width, layout.height);
    for (int y = 0; y < layout.height; ++y) {
        for (int x = 0; x < layout.width; ++x)
            costs(x, y) = paths[layout.node(x, y)].cost;
    }
    return costs;
}

// The same cost at the land's nodes.
Field<float> on_land(const Field<float>& costs, const Site& site) {
    const Graph& land = site.graph;
    const double x_scale = 1.0 * costs.width() / land.width;
    const double y_scale = 1.0 * costs.height() / land.height;
    Field<float> result(land.width, land.height);
    for (int y = 0; y < land.height; ++y) {
        for (int x = 0; x < land.width; ++x) {
            result(x, y) =
                bilinear(costs, (x + 0.5) * x_scale - 0.5, (y + 0.5) * y_scale - 0.5);
        }
    }
    return result;
}

// The centres of the cells for which `is_in` is true.
template <class IsIn>
std::vector<SitePoint> cells_where(const Field<float>& costs, const Graph& graph,
                                   const Site& site, float cost, const IsIn& is_in) {
    std::vector<SitePoint> places;
    for (int y = 0; y < costs.height(); ++y) {
        for (int x = 0; x < costs.width(); ++x) {
            if (!is_in(costs, x, y)) continue;
            places.push_back(site.centre_of(graph, graph.node(x, y)));
            places.back().cost = cost;
            places.back().root = static_cast<int>(places.size()) - 1;
        }
    }
    return places;
}

void link_to_nearest(Shape& shape) {
    PointIndex index(2.0 * shape.pitch);
    for (std::size_t i = 0; i < shape.places.size(); ++i) {
        index.add(shape.places[i].x, shape.places[i].y, static_cast<int>(i));
    }
    for (SitePoint& place : shape.land) {
        double least = 1e300;
        index.within(place.x, place.y, 4.0 * shape.pitch, [&](int name, double square) {
            if (square < least) {
                least = square;
                place.root = name;
            }
            return true;
        });
    }
}

// The shape of the cells whose path cost satisfies `is_in`, on the layout and on the
// land.
template <class IsIn>
Shape shape_where(const Field<float>& costs, const Field<float>& land, const Site& site,
                  float cost, const IsIn& is_in) {
    Shape shape;
    shape.pitch = static_cast<float>(site.layout().spacing);
    shape.places = cells_where(costs, site.layout(), site, cost, is_in);
    shape.land = cells_where(land, site.graph, site, cost, is_in);
    return shape;
}

void check(const Terraces& terraces, const std::string& group, double width) {
    if (terraces.levels.empty()) {
        throw bad_request("group '{}': its terraces have no level; add one", group);
    }
    for (std::size_t i = 0; i < terraces.levels.size(); ++i) {
        const auto [low, high] = terraces.levels[i].range;
        const double cost = terraces.levels[i].cost.in(width);
        if (!(cost >= 0.0)) {
            throw bad_request("group '{}': terrace {} costs {} m: it must be at least 0",
                              group, i + 1, cost);
        }
        if (!(low >= 0.0 && low < high && high <= 1.0)) {
            throw bad_request(
                "group '{}': terrace {} is from {} to {}: shares must rise, from 0 to 1",
                group, i + 1, low, high);
        }
        if (i > 0 && !(high <= terraces.levels[i - 1].range[0])) {
            throw bad_request(
                "group '{}': terrace {} reaches {}, above the {} where the one before it "
                "begins: give them from the farthest from the strokes to the nearest",
                group, i + 1, high, terraces.levels[i - 1].range[0]);
        }
    }
}

}  // namespace

std::vector<Shape> terrace_shapes(const Terraces& terraces, const std::string& group,
                                  const Site& site) {
    check(terraces, group, site.width);
    const Field<float> costs = costs_from(terraces.image, site);
    const Field<float> land = on_land(costs, site);
    const double greatest = *std::max_element(costs.begin(), costs.end());
    std::vector<Shape> shapes;
    for (const Terraces::Level& level : terraces.levels) {
        const double low = level.range[0] * greatest, high = level.range[1] * greatest;
        const auto cost = static_cast<float>(level.cost.in(site.width));
        const auto is_in = [&](const Field<float>& at, int x, int y) {
            return at(x, y) > low && at(x, y) <= high;
        };
        shapes.push_back(shape_where(costs, land, site, cost, is_in));
        if (shapes.back().land.empty() || shapes.back().places.empty()) {
            throw bad_request("group '{}': no ground lies in terrace {}, from {} to {}",
                              group, shapes.size(), level.range[0], level.range[1]);
        }
    }
    return shapes;
}

std::vector<Shape> lip_shape(const Lip& lip, const std::string& group, const Site& site) {
    const double distance = lip.distance.in(site.width);
    if (!(distance > 0.0)) {
        throw bad_request("group '{}': distance is {} m: it must be above 0", group,
                          distance);
    }
    // A path over mean edge weights costs mu_w a metre.
    const double cost = distance * site.options.mean_edge_weight;
    const auto is_in = [&](const Field<float>& at, int x, int y) {
        const auto beyond = [&](int i, int j) {
            return at.contains(i, j) && at(i, j) > cost;
        };
        return at(x, y) <= cost && (beyond(x - 1, y) || beyond(x + 1, y) ||
                                    beyond(x, y - 1) || beyond(x, y + 1));
    };
    const Field<float> costs = costs_from(lip.image, site);
    Shape shape = shape_where(costs, on_land(costs, site), site, 0.0f, is_in);
    if (shape.land.empty() || shape.places.empty()) {
        throw bad_request("group '{}': no ground lies {} m from the strokes of {}", group,
                          distance, lip.image.name());
    }
    link_to_nearest(shape);
    return {std::move(shape)};
}

}  // namespace cydonia::distance
