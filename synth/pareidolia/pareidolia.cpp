#include "synth/pareidolia/pareidolia.h"

#include <utility>

#include "field/error.h"
#include "synth/pareidolia/constrained/constrained.h"
#include "synth/pareidolia/features.h"
#include "synth/pareidolia/image.h"

namespace cydonia::pareidolia {
namespace {

void check_options(const Options& options) {
    if (!(options.features.edge_weight_deviation >= 0.0 &&
          options.features.edge_weight_deviation < options.features.mean_edge_weight))
        throw bad_request(
            "edge_weight_deviation (r = {}) must be at least 0 and below "
            "mean_edge_weight (mu_w = {})",
            options.features.edge_weight_deviation, options.features.mean_edge_weight);
}

}  // namespace

Terrain run(const Options& options, const Terrain& terrain, const Context& context) {
    check_options(options);
    Terrain result = terrain;
    std::vector<ShadowImage> images = shadow_images(options, terrain, *context.progress);
    result.heights = options.solver == Solver::kFeatures
                         ? features(options, terrain, images.front(), context)
                         : constrained(options, terrain, images, context);
    for (ShadowImage& image : images) result.shadows.push_back(std::move(image));
    return result;
}

}  // namespace cydonia::pareidolia
