// B. Rusnell, "Distance-based terrain synthesis" (2009), section 6.2.

#include "synth/distance/water.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "field/error.h"
#include "field/strokes.h"
#include "synth/distance/cost_model.h"

namespace cydonia::distance {
namespace {

// A low bank separates the water from land that lies lower. It rises at a tenth of the
// shore slope and falls again at the full slope, so that it ends at this distance from
// the shore.
const double kBank = thesis_units(10.0).fraction;  // of the width
constexpr float kBankRise = 0.1f;

// The grey of a picture. The shore is where it passes one half, anywhere between two
// samples.
bool is_wet(float grey) { return grey < 0.5f; }

Field<float> drawn(const Source& image, const Graph& graph) {
    Field<float> grey = read_grey_at(image, graph.width, graph.height);
    const auto wet = static_cast<std::size_t>(std::ranges::count_if(grey, is_wet));
    if (wet == 0 || wet == grey.size()) {
        throw bad_request(
            "water: {} shows {}: draw the water dark and leave the land light",
            image.name(), wet == 0 ? "no water" : "nothing but water");
    }
    return grey;
}

// The distance in cells from a sample to the shore, when the shore passes between it and
// a sample beside it; otherwise infinite.
float to_shore(const Field<float>& grey, int x, int y) {
    const float here = grey(x, y);
    const auto along = [&](int dx, int dy) {
        if (!grey.contains(x + dx, y + dy)) return kUnreached;
        const float there = grey(x + dx, y + dy);
        return is_wet(there) == is_wet(here) ? kUnreached
                                             : (0.5f - here) / (there - here);
    };
    const float across = std::min(along(-1, 0), along(1, 0));
    const float down = std::min(along(0, -1), along(0, 1));
    return 1.0f / std::hypot(1.0f / across, 1.0f / down);  // to the line through both
}

// The samples next to the shore on one side of it. Their costs are `fall(metres)` of
// their distance from it.
template <class Fall>
std::vector<Start> shore_of(const Field<float>& grey, const Graph& graph, bool wet,
                            const Fall& fall) {
    std::vector<Start> shore;
    for (int y = 0; y < grey.height(); ++y) {
        for (int x = 0; x < grey.width(); ++x) {
            if (is_wet(grey(x, y)) != wet) continue;
            const float cells = to_shore(grey, x, y);
            if (cells == kUnreached) continue;
            shore.push_back(
                {graph.node(x, y), fall(cells * static_cast<float>(graph.spacing))});
        }
    }
    return shore;
}

class Shores {
  public:
    Shores(Terrain& terrain, const Options& options, const Graph& graph)
        : terrain_(terrain),
          options_(options),
          graph_(graph),
          paths_(graph),
          low_(graph.width, graph.height, kDry),
          high_(graph.width, graph.height, -kDry) {}

    // The waters are laid one after another, since a lake's level may be that of land
    // that a sea has lowered.
    void add(const Water& water) {
        const Field<float> grey = drawn(water.image, graph_);
        const float level = level_of(water, grey);
        lay_bed(water, grey, level);
        bound_land(water, grey, level);
    }

    // Where two waters contradict each other, a steep bank holds the higher one.
    void shape_land() {
        for (std::size_t i = 0; i < low_.size(); ++i) {
            if (terrain_.water[i] == kDry) terrain_.heights[i] = bounded(i);
        }
    }

  private:
    float bounded(std::size_t i) const {
        return std::max(std::min(terrain_.heights[i], high_[i]), low_[i]);
    }

    float level_of(const Water& water, const Field<float>& grey) const {
        if (water.level) return static_cast<float>(water.level->in(terrain_.width()));
        float lowest = kUnreached;
        for (int y = 0; y < grey.height(); ++y) {
            for (int x = 0; x < grey.width(); ++x) {
                if (is_wet(grey(x, y)) && to_shore(grey, x, y) != kUnreached) {
                    lowest = std::min(lowest, bounded(grey.index(x, y)));
                }
            }
        }
        return lowest;
    }

    void lay_bed(const Water& water, const Field<float>& grey, float level) {
        const double width = terrain_.width();
        const double depth = water.depth.in(width);
        const auto deepest = static_cast<float>(depth);
        const auto bed = std::ranges::find(options_.profiles, water.bed, &Profile::name);
        Shapes shapes{.sea_level = depth, .mean_edge_weight = options_.mean_edge_weight};
        shapes.descents.push_back(descent_of(*bed, depth, options_.mean_edge_weight,
                                             options_.minimum_scale, width));
        const auto shore = shore_of(grey, graph_, true, [&](float metres) {
            return std::min(shapes.descents[0](metres), 0.5f * deepest);
        });
        shapes.ways.assign(shore.size(), 0);
        paths_.spread(shore, ProfileCostModel(shapes, shore, 0),
                      [&](int, float cost) { return cost < deepest; });
        for (std::size_t i = 0; i < grey.size(); ++i) {
            if (!is_wet(grey[i])) continue;
            terrain_.heights[i] = level - std::min(cost_at(i), deepest);
            terrain_.water[i] = level;
        }
    }

    void bound_land(const Water& water, const Field<float>& grey, float level) {
        const auto slope = static_cast<float>(water.shore_slope);
        const auto shore =
            shore_of(grey, graph_, false, [&](float metres) { return slope * metres; });
        const std::vector<float> factors(
            shore.size(), slope / static_cast<float>(options_.mean_edge_weight));
        paths_.spread(shore, ConstantCostModel{shore, factors});
        const float bank = slope * static_cast<float>(kBank * terrain_.width());
        for (std::size_t i = 0; i < grey.size(); ++i) {
            const float rise = cost_at(i);
            high_[i] = std::min(high_[i], level + rise);
            low_[i] = std::max(low_[i], level + std::min(kBankRise * rise, bank - rise));
        }
    }

    float cost_at(std::size_t i) const {
        const int cell = static_cast<int>(i);
        return paths_[graph_.node(cell % graph_.width, cell / graph_.width)].cost;
    }

    Terrain& terrain_;
    const Options& options_;
    const Graph& graph_;
    LeastCost paths_;
    Field<float> low_, high_;  // what the land may be, by the shores so far
};

}  // namespace

void lay_water(Terrain& terrain, const Options& options, const Graph& graph) {
    if (options.water.empty()) return;
    if (terrain.water.empty()) {
        terrain.water = Field<float>(graph.width, graph.height, kDry);
    }
    Shores shores(terrain, options, graph);
    for (const Water& water : options.water) shores.add(water);
    shores.shape_land();
}

}  // namespace cydonia::distance
