#include "synth/genetic/placed.h"

#include <algorithm>
#include <memory>

#include "field/sample.h"
#include "field/smoothstep.h"
#include "synth/texture/constraints/geometry.h"

namespace cydonia::genetic {

PlacedFeatures features_of(const std::vector<geometry::Point>& points,
                           const std::vector<geometry::Curve>& curves,
                           const Extent& extent, Progress& progress) {
    if (points.empty() && curves.empty()) return {};
    texture::Options options;
    options.points = points, options.curves = curves;
    // The base level's land without placed features, for heights that are relative to it.
    auto natural = std::make_shared<Field<float>>();
    auto spacing_of = std::make_shared<double>(0.0);
    return [options, extent, natural, spacing_of, &progress](Field<float>& heights,
                                                             double spacing) {
        if (natural->empty()) *natural = heights, *spacing_of = spacing;
        const auto at = [&](double x, double y) {
            return bilinear(*natural, x / *spacing_of - 0.5,
                            (extent.depth() - y) / *spacing_of - 0.5);
        };
        const texture::Geometry geometry(
            options, {extent.width(), extent.depth(), spacing}, at, progress);
        const Field<texture::Pull> pulls =
            geometry.pulls({0, 0, 0, heights.width(), heights.height()});
        for (std::size_t i = 0; i < heights.size(); ++i) {
            const texture::Pull& pull = pulls[i];
            if (!(pull.reach > 0.0f)) continue;
            const double share = std::clamp(1.0 - pull.distance / pull.reach, 0.0, 1.0);
            heights[i] += float(smoothstep(0.0, 1.0, share) * (pull.target - heights[i]));
        }
    };
}

}  // namespace cydonia::genetic
