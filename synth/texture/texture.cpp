#include "synth/texture/texture.h"

#include "synth/texture/maker.h"
#include "synth/texture/patches.h"

namespace cydonia::texture {
namespace {

// Cells whose height no exemplar has (notes.md, Gain 6).
Field<float> outside_range(const Field<float>& heights, const Database& database) {
    Field<float> outside(heights.width(), heights.height());
    for (std::size_t i = 0; i < heights.size(); ++i)
        outside[i] =
            heights[i] < database.lowest || heights[i] > database.highest ? 1.0f : 0.0f;
    return outside;
}

double share(const Field<float>& mask) {
    double sum = 0.0;
    for (const float value : mask) sum += value;
    return sum / static_cast<double>(mask.size());
}

}  // namespace

Terrain run(const Options& options, const Terrain& terrain, const Context& context) {
    const int width = terrain.heights.width(), height = terrain.heights.height();
    const Maker maker(options, {width, height, terrain.spacing}, context);

    context.progress->step("texture: synthesis");
    const Synthesis land =
        maker.synthesis(0, 0, width, height, maker.guidance(), nullptr);

    Terrain result;
    result.spacing = terrain.spacing;
    result.heights = maker.heights(land, 0, 0, width, height);
    result.masks["outside-exemplars"] = outside_range(result.heights, maker.database());
    result.figures["texture: outside the exemplars' heights, share"] =
        share(result.masks["outside-exemplars"]);
    result.pictures["sources"] = source_map(maker.database(), land.places);
    return result;
}

Field<float> tile(const Options& options, const Extent& extent, const Context& context,
                  int x, int y, int width, int height) {
    const Maker maker(options, extent, context);
    context.progress->step("texture: synthesis");
    return maker.heights(maker.synthesis(x, y, width, height, maker.guidance(), nullptr),
                         x, y, width, height);
}

}  // namespace cydonia::texture
