#include "synth/distance/site.h"

#include <algorithm>

#include "field/random.h"

namespace cydonia::distance {
namespace {

constexpr double kLattice = 1024.0;

int lattice_cells(double side, double longer) {
    return std::max(1, static_cast<int>(std::lround(kLattice * side / longer)));
}

}  // namespace

Site::Site(const Options& all_options, const Graph& land_graph,
           const Terrain& terrain_so_far, std::uint64_t stage_seed)
    : options(all_options),
      graph(land_graph),
      terrain(terrain_so_far),
      seed(stage_seed),
      width(land_graph.width * land_graph.spacing),
      depth(land_graph.height * land_graph.spacing),
      columns(lattice_cells(width, std::max(width, depth))),
      rows(lattice_cells(depth, std::max(width, depth))) {}

const Graph& Site::layout() const {
    if (!layout_) {
        layout_ =
            std::make_unique<Graph>(layout_graph(graph, edges_of(options, width), seed));
    }
    return *layout_;
}

SitePoint Site::centre_of(const Graph& of, int node) const {
    return {static_cast<float>((of.x_of(node) + 0.5) * of.spacing),
            static_cast<float>((of.y_of(node) + 0.5) * of.spacing)};
}

int node_at(const Graph& graph, double x, double y) {
    const auto cell = [&](double metres, int cells) {
        return std::clamp(static_cast<int>(metres / graph.spacing), 0, cells - 1);
    };
    return graph.node(cell(x, graph.width), cell(y, graph.height));
}

std::uint64_t key_of(const std::string& name) { return key(name.c_str()); }

void append_line(std::vector<SitePoint>& line, const SitePoint& a, const SitePoint& b,
                 double step) {
    const double longer = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
    const int parts = std::max(1, static_cast<int>(std::ceil(longer / step - 1e-3)));
    for (int i = 1; i <= parts; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(parts);
        line.push_back({std::lerp(a.x, b.x, t), std::lerp(a.y, b.y, t),
                        std::lerp(a.cost, b.cost, t), 2 * i < parts ? a.root : b.root});
    }
}

}  // namespace cydonia::distance
