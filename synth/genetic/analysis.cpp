#include "synth/genetic/analysis.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "field/sampled.h"
#include "field/vec.h"
#include "synth/genetic/edges.h"

namespace cydonia::genetic {
namespace {

std::vector<float> slopes_of(const Terrain& terrain) {
    const Field<float>& h = terrain.heights;
    std::vector<float> slopes;
    slopes.reserve(h.size());
    for (int y = 1; y + 1 < h.height(); ++y)
        for (int x = 1; x + 1 < h.width(); ++x) {
            const double east = (h(x + 1, y) - h(x - 1, y)) / (2.0 * terrain.spacing),
                         north = (h(x, y - 1) - h(x, y + 1)) / (2.0 * terrain.spacing);
            slopes.push_back(float(degrees(std::atan(std::hypot(east, north)))));
        }
    return slopes;
}

}  // namespace

Analysis analysis_of(const Terrain& terrain) {
    std::vector<float> scales, lengths, strengths;
    for (const Edge& edge : edges_of(terrain.heights, terrain.spacing)) {
        scales.push_back(edge.scale), lengths.push_back(edge.length);
        strengths.push_back(edge.strength);
    }
    return {statistics_of({terrain.heights.begin(), terrain.heights.size()}),
            statistics_of(slopes_of(terrain)), statistics_of(scales),
            statistics_of(lengths), statistics_of(strengths)};
}

Terrain at_level(const Terrain& terrain, double spacing) {
    const double cell = spacing / terrain.spacing;
    const int width = std::max(1, int(terrain.heights.width() / cell + 1e-9)),
              height = std::max(1, int(terrain.heights.height() / cell + 1e-9));
    Terrain result;
    result.spacing = spacing;
    result.heights = sampled(terrain.heights, {0.0, 0.0, cell}, width, height);
    return result;
}

}  // namespace cydonia::genetic
