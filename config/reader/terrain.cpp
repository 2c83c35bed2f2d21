#include <algorithm>
#include <array>

#include "config/reader/readers.h"

namespace cydonia::config {
namespace {

template <class Options>
StageOptions stage_of(Table& t) {
    Options options;
    read(t, options);
    return options;
}

// Every method by its name, and what reads it.
constexpr Name<StageOptions (*)(Table&)> kMethods[] = {
    {"dem", stage_of<dem::Options>},
    {"distance", stage_of<distance::Options>},
    {"pareidolia", stage_of<pareidolia::Options>},
    {"texture", stage_of<texture::Options>},
};

constexpr std::size_t kMostStages = 64;

}  // namespace

void read(Table& t, StageSpec& stage) {
    StageOptions (*options_of)(Table&) = nullptr;
    if (t.required("method", options_of, one_of(kMethods)))
        stage.options = options_of(t);
    else
        t.ignore_unknown();  // without a method, no key can be judged
    stage.text = t.record().text();
    stage.sources = t.record().sources;
}

void read(Table& t, TerrainTable& out) {
    auto& [terrain, stages] = out;
    std::array<double, 2> extent{terrain.width, terrain.depth};
    t.field("extent", extent, Number{above_to(0.0, 1e7)});
    t.field("samples", terrain.samples, Whole{2, 16384});
    const auto [shorter, longer] = std::minmax(extent[0], extent[1]);
    t.check(terrain.samples * shorter >= 2.0 * longer, {"extent", "samples"},
            "too narrow: the shorter side would have less than 2 samples");
    terrain.width = extent[0];
    terrain.depth = extent[1];
    t.tables("stage", stages, kMostStages);
    t.check(!stages.empty(), {"stage"}, "a scene needs at least one [[terrain.stage]]");
}

}  // namespace cydonia::config
