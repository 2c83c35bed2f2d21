#include "synth/statistics/analysis.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"
#include "field/sampled.h"
#include "synth/statistics/measures.h"

namespace cydonia::statistics {
namespace {

// The region that holds more than half of a feature; -1: none does.
int region_of(const Feature& feature, const Field<int>& regions, int count) {
    // Only one region can hold more than half: the majority vote of Boyer and Moore 1991.
    int region = -1;
    std::size_t lead = 0, own = 0;
    for (const std::uint32_t i : feature.samples) {
        if (lead == 0) region = regions[i];
        if (regions[i] == region)
            ++lead;
        else
            --lead;
    }
    for (const std::uint32_t i : feature.samples) own += regions[i] == region;
    return 2 * own > feature.samples.size() && region < count ? region : -1;
}

}  // namespace

std::vector<Analysis> analyses_of(const Terrain& terrain, const Field<int>& regions,
                                  int count) {
    const Measures measures = measures_of(terrain);
    std::vector<std::vector<int>> homes;  // regions of each kind's features
    for (const Measures::Kind& kind : measures.kinds) {
        std::vector<int>& home = homes.emplace_back();
        for (const Feature& feature : kind.features)
            home.push_back(region_of(feature, regions, count));
    }
    std::vector<Analysis> analyses(std::size_t(std::max(0, count)));
    // Each quantity is handled by one thread, so that the order of its values is always
    // the same.
    parallel_for(kQuantities, [&](int q) {
        std::vector<std::vector<float>> values(analyses.size());
        const auto quantity = Quantity(q);
        for (const auto& [its, field] : measures.fields)
            for (std::size_t i = 0; its == quantity && i < field.size(); ++i)
                if (regions[i] >= 0 && regions[i] < count && std::isfinite(field[i]))
                    values[std::size_t(regions[i])].push_back(field[i]);
        for (std::size_t k = 0; k < measures.kinds.size(); ++k)
            for (const auto& [its, number] : measures.kinds[k].numbers)
                for (std::size_t f = 0; its == quantity && f < homes[k].size(); ++f)
                    if (homes[k][f] >= 0)
                        values[std::size_t(homes[k][f])].push_back(
                            measures.kinds[k].features[f].*number);
        for (std::size_t r = 0; r < analyses.size(); ++r)
            analyses[r][std::size_t(q)] = statistics_of(values[r]);
    });
    return analyses;
}

Analysis analysis_of(const Terrain& terrain, const Field<std::uint8_t>& inside) {
    Field<int> regions(terrain.heights.width(), terrain.heights.height());
    for (std::size_t i = 0; i < regions.size(); ++i) regions[i] = inside[i] ? 0 : -1;
    return analyses_of(terrain, regions, 1)[0];
}

Analysis analysis_of(const Terrain& terrain) {
    return analyses_of(
        terrain, Field<int>(terrain.heights.width(), terrain.heights.height()), 1)[0];
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

}  // namespace cydonia::statistics
