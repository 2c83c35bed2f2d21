#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "field/enum_names.h"
#include "field/sun.h"
#include "render/cameras/options.h"
#include "render/colour/options.h"
#include "render/fine_relief/options.h"
#include "render/ground/options.h"
#include "render/passes/options.h"
#include "render/sky/options.h"
#include "render/things/options.h"

namespace cydonia::render {

enum class Quality { kDraft, kPreview, kFinal };
inline constexpr Name<Quality> kQualities[] = {{"draft", Quality::kDraft},
                                               {"preview", Quality::kPreview},
                                               {"final", Quality::kFinal}};
static_assert(is_complete(kQualities, Quality::kFinal));
constexpr std::string_view name_of(Quality quality) {
    return name_in(kQualities, quality);
}

struct Options {
    std::optional<Sun> sun;  // default: the first shadow image's; else 315, 35 degrees
    std::vector<CameraOptions> cameras;  // default: overhead and oblique
    SkyOptions sky;
    HazeOptions haze;
    std::optional<WaterOptions> water;
    FineReliefOptions fine_relief;
    GroundOptions ground;
    std::vector<ThingOptions> things;  // on the ground; default: none
    ColourOptions colour;
    std::optional<PassOptions> passes;  // default: none
};

}  // namespace cydonia::render
