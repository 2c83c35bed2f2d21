#include <fmt/core.h>

#include "render/pov/pieces.h"

namespace cydonia::render::pov {
namespace {

// Waves of three lengths, without those too small to be seen.
std::string waves(const Camera& camera) {
    std::string lengths;
    constexpr struct {
        int metres;
        double bump;
    } kWaves[] = {{3, 0.04}, {17, 0.02}, {70, 0.008}};
    for (const auto& [metres, bump] : kWaves)
        if (metres > 2.0 * pixel_size(camera))
            lengths +=
                fmt::format("            [1 bumps {} scale {} / Unit ]\n", bump, metres);
    if (lengths.empty()) return "";
    return fmt::format(
        "    normal {{\n        average normal_map {{\n{}        }}\n    }}\n", lengths);
}

const char* skylight(const Shot& shot) {
    return has_radiosity(shot.quality) ? "" : " emission SkyLight * SkyFill";
}

std::string open_sea(double level) {
    return fmt::format(R"(
// The sea goes on around the land.
plane {{
    y, {} / Unit
    clipped_by {{
        box {{
            At(Spacing / 2, Spacing / 2, -1e6),
            At(LandWidth - Spacing / 2, LandDepth - Spacing / 2, 1e6)
            inverse
        }}
    }}
    texture {{ ClearWater }}
    interior {{ InWater }}
    no_shadow
}}
)",
                       number(level));
}

}  // namespace

std::string flood(const Shot& shot) {
    const Length level = shot.options.water->level;
    return fmt::format(R"(
// Water: dark by itself, it mirrors the sky where it is seen at a low angle.
#declare WaterLevel = {} + {} * LandWidth;
#declare Water = texture {{
    pigment {{ color rgb <{}> }}
{}    finish {{ reflection {{ 0, 1 fresnel on }} conserve_energy{} }}
}};
plane {{
    y, WaterLevel / Unit
    #if (WaterLevel < OutskirtsHeight) // a lake: not under the outskirts
        clipped_by {{
            box {{
                At(-Around * LandWidth, -Around * LandDepth, -1e6),
                At((Around + 1) * LandWidth, (Around + 1) * LandDepth, 1e6)
            }}
        }}
    #end
    texture {{ Water }}
    interior {{ ior {} }}
}}
)",
                       number(level.metres), number(level.fraction),
                       numbers(kFloodColour), waves(shot.camera), skylight(shot),
                       number(kWaterIndex));
}

std::string water(const Shot& shot, const WaterSurface& surface) {
    return fmt::format(
               R"(
// Seas and lakes: a blue-green veil over the bed, whose colour in ground.png is what their
// depth leaves of it, and a mirror of the sky where they are seen at a low angle.
#declare ClearWater = texture {{
    pigment {{ color rgbt <{}, {}> }}
{}    finish {{
        reflection {{ 0, 1 fresnel on }} conserve_energy{}
        specular 0.5 roughness 0.004 // the sun
    }}
}};
#declare InWater = interior {{ ior {} }};

// Their surface is at its level where they are and under the land beside the shore, which
// hides it; elsewhere it is cut away.
#declare Lakes = height_field {{
    png "water.png" gamma 1.0 water_level 0.5 / 65535
    scale At(LandWidth - Spacing, LandDepth - Spacing, {})
    translate At(Spacing / 2, Spacing / 2, {})
    texture {{ ClearWater }}
    interior {{ InWater }}
    no_shadow
}}
object {{ Lakes }}
{})",
               numbers(kWaterVeil), number(kWaterClear), waves(shot.camera),
               skylight(shot), number(kWaterIndex), number(surface.heights.range),
               number(surface.heights.base),
               shot.around == Around::kLand ? "Again(Lakes)\n" : "") +
           (surface.sea ? open_sea(*surface.sea) : "");
}

}  // namespace cydonia::render::pov
