#include "synth/pareidolia/pareidolia.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "field/error.h"
#include "synth/pareidolia/constrained/constrained.h"
#include "synth/pareidolia/features.h"
#include "synth/pareidolia/light_frame.h"
#include "synth/pareidolia/target.h"

namespace cydonia::pareidolia {
namespace {

void check_options(const Options& options) {
    if (options.solver == Solver::kFeatures && options.images.size() != 1)
        throw bad_request(
            "solver = \"features\" takes exactly one image, this stage has {}",
            options.images.size());
    if (!(options.features.edge_weight_deviation >= 0.0 &&
          options.features.edge_weight_deviation < options.features.mean_edge_weight))
        throw bad_request(
            "edge_weight_deviation (r = {}) must be at least 0 and below "
            "mean_edge_weight (mu_w = {})",
            options.features.edge_weight_deviation, options.features.mean_edge_weight);
    const double elevation = options.images.front().elevation.value_or(radians(25.0));
    if (!(elevation > 0.0 && elevation < radians(89.9)))
        throw bad_request(
            "sun: elevation {} degrees casts no shadow: above 0 and below 90",
            degrees(elevation));
}

// The image at one size for every number of samples, so that the search for a sun finds
// the same one.
Field<std::uint8_t> small_target(const ImageOptions& options, const Terrain& terrain) {
    constexpr int kLonger = 256;
    const double longer = std::max(terrain.width(), terrain.depth());
    const auto cells = [&](double metres) {
        return std::max(1, static_cast<int>(std::lround(kLonger * metres / longer)));
    };
    SilentProgress silent;
    return shadow_target(options, cells(terrain.width()), cells(terrain.depth()), silent);
}

ShadowImage shadow_image(const ImageOptions& options, const Terrain& terrain,
                         Progress& progress) {
    ShadowImage image;
    image.name = image_name(options);
    image.target = shadow_target(options, terrain.heights.width(),
                                 terrain.heights.height(), progress);
    image.sun.elevation = options.elevation.value_or(radians(25.0));
    image.min_iou = options.min_iou;
    if (options.azimuth) {
        image.sun.azimuth = *options.azimuth;
    } else {
        image.sun.azimuth = shortest_azimuth(small_target(options, terrain));
        progress.note(
            fmt::format("{}: the sun stands at azimuth {:.0f} degrees, where the "
                        "longest shadow is shortest",
                        image.name, degrees(image.sun.azimuth)));
    }
    return image;
}

}  // namespace

Terrain run(const Options& options, const Terrain& terrain, const Context& context) {
    check_options(options);
    Terrain result = terrain;
    std::vector<ShadowImage> images;
    for (const ImageOptions& image : options.images)
        images.push_back(shadow_image(image, terrain, *context.progress));
    result.heights = options.solver == Solver::kFeatures
                         ? features(options, terrain, images.front(), context)
                         : constrained(options, terrain, images, context);
    for (ShadowImage& image : images) result.shadows.push_back(std::move(image));
    return result;
}

}  // namespace cydonia::pareidolia
