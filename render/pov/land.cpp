// The land and its surroundings.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "field/border.h"
#include "render/pov/pieces.h"

namespace cydonia::render::pov {
namespace {

// The power of ten that makes the land 50 to 500 units wide. POV-Ray's tolerances are
// absolute: with units of one metre land of kilometres gets black specks.
double metres_a_unit(double size) {
    return std::pow(10.0, std::floor(std::log10(size / 50.0)));
}

double lowest_border(const Heights16& heights) {
    return heights.base + heights.range * lowest_on_border(heights.levels) / 65535.0;
}

constexpr const char* kDeepGround =
    R"(    texture { pigment { color rgb 0 } } // under the sea
)";

constexpr const char* kSidesAlone = R"(object { Sides }
#declare Around = 0; // lands on each side of the land
)";

// Copies cast no shadows: the land's shadows must be those that were checked.
constexpr const char* kLandAround =
    R"(#declare Around = 2; // lands on each side of the land
// The land again, mirrored at its borders so that none shows. Only the land itself throws
// shadows.
#declare Mirrored = function(Lands) { 1 - 2 * mod(abs(Lands), 2) };
#macro Again(Piece)
    #for (I, -Around, Around)
        #for (J, -Around, Around)
            #if (I != 0 | J != 0)
                object { Piece
                    translate -At(LandWidth / 2, LandDepth / 2, 0)
                    scale <Mirrored(I), 1, Mirrored(J)>
                    translate At(LandWidth / 2 + I * (LandWidth - Spacing),
                                 LandDepth / 2 + J * (LandDepth - Spacing), 0)
                    no_shadow
                }
            #end
        #end
    #end
#end
Again(object { Land texture { Ground } })
Again(Sides)
)";

constexpr const char* kGroundUnderVisibility =
    R"(// Sunlight is traced; skylight is what sky_visibility.png leaves of it: white is a place
// that sees the whole sky, black one that sees none.
#declare Ground = texture {
    image_pattern { png "sky_visibility.png" gamma 1.0 interpolate 2 }
    texture_map {
        [0 pigment { GroundColour } ]
        [1 pigment { GroundColour } finish { emission SkyLight * SkyFill } ]
    }
    transform { FromAbove }
};
)";

// The amount of a material's bumps, which are finer than the heights. Bumps as small as a
// pixel would flicker, so they fade out.
double shown_bump(const Material& material, const Camera& camera) {
    if (camera.projection != Camera::Projection::kPerspective) return 0.0;
    const double pixels = material.bump_size / pixel_size(camera);
    return material.bump * std::clamp((pixels - 1.5) / 3.0, 0.0, 1.0);
}

std::string bumps(const Shot& shot) {
    const std::vector<Material>& materials = shot.options.ground.look.materials;
    std::string entries;
    double most = 0.0;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const double bump = shown_bump(materials[i], shot.camera);
        most = std::max(most, bump);
        entries += fmt::format(
            "            [{} / 255 granite {} scale {} / Unit transform {{ FromAbove "
            "inverse "
            "}} ]\n",
            i, number(bump), number(materials[i].bump_size));
    }
    if (most <= 0.0) return "";
    return fmt::format(R"(
    normal {{ // bumps of what lies there: materials.png has its number in the look
        image_pattern {{ png "materials.png" gamma 1.0 }}
        normal_map {{
{}        }}
        transform {{ FromAbove }}
    }})",
                       entries);
}

std::string ground_under_radiosity(const Shot& shot) {
    return fmt::format(R"(#declare Ground = texture {{
    pigment {{ GroundColour transform {{ FromAbove }} }}{}
}};
)",
                       bumps(shot));
}

}  // namespace

std::string land_numbers(const Heights16& heights, double spacing) {
    const double width = spacing * heights.levels.width();
    const double depth = spacing * heights.levels.height();
    return fmt::format(
        R"(// The land, in metres. Its heights stand at the centres of square cells.
#declare LandWidth  = {}; // west to east
#declare LandDepth  = {}; // south to north
#declare Spacing    = {}; // from one height to the next
#declare BaseHeight = {}; // the lowest ground
#declare Relief     = {}; // from there to the highest

// One POV-Ray unit in metres.
#declare Unit = {};

// From metres east, north and up of the land's south-west corner to POV-Ray's space, where
// x is east, y up and z north.
#macro Towards(East, North, Up) (<East, Up, North>) #end
#macro At(East, North, Up) (Towards(East, North, Up) / Unit) #end

#declare LandSize = max(LandWidth, LandDepth);
#declare Middle = At(LandWidth / 2, LandDepth / 2, BaseHeight + Relief / 2);

)",
        number(width), number(depth), number(spacing), number(heights.base),
        number(heights.range), number(metres_a_unit(std::max(width, depth))));
}

// POV-Ray computes smooth normals on its integer grid, with 65535 levels and one unit
// from sample to sample, and stores them in 16 bits. They are off by up to Spacing /
// Relief radians, which does not show in perspective, whereas facets would.
std::string ground(const Shot& shot) {
    return fmt::format(
        R"(// The ground's colour covers the cells, draped from above.
#declare FromAbove = transform {{ rotate 90 * x scale At(LandWidth, LandDepth, Unit) }}
#declare GroundColour = pigment {{
    image_map {{ png "ground.png" gamma srgb interpolate 2 }}
}}
{}
// The heights are corners of the surface, which so ends half a cell inside the land.
#declare Land = height_field {{
    png "heights.png" gamma 1.0{}
    scale At(LandWidth - Spacing, LandDepth - Spacing, Relief)
    translate At(Spacing / 2, Spacing / 2, BaseHeight)
}}
object {{ Land texture {{ Ground }} }}

)",
        has_radiosity(shot.quality) ? ground_under_radiosity(shot)
                                    : kGroundUnderVisibility,
        shot.smooth ? " smooth" : "");
}

std::string outskirts(const Shot& shot, const Heights16& heights, bool under_sea) {
    const char* skylight =
        has_radiosity(shot.quality) ? "" : " finish { emission SkyLight * SkyFill }";
    const bool goes_on = shot.around == Around::kLand;
    return fmt::format(
        R"(// Around the land: its sides, and level country of the ground's mean colour at the height
// of the lowest border, so that no view ends in nothing.
#declare OutskirtsHeight = {};
#declare ColourAt = function {{ pigment {{ GroundColour }} }}
#declare MeanColour = rgb 0;
#for (I, 0, 31)
    #for (J, 0, 31)
        #declare MeanColour =
            MeanColour + ColourAt((I + 0.5) / 32, (J + 0.5) / 32, 0) / 1024;
    #end
#end
#declare MeanGround = texture {{ pigment {{ color MeanColour }}{} }}
#declare Sides = box {{
    At(Spacing / 2, Spacing / 2, BaseHeight) + 1e-4,
    At(LandWidth - Spacing / 2, LandDepth - Spacing / 2, BaseHeight + 2 * Relief) - 1e-4
    clipped_by {{ Land }}
    texture {{ MeanGround }}
    hollow // haze fills the box too
}}
{}plane {{
    y, OutskirtsHeight / Unit
    clipped_by {{
        box {{
            At(Spacing / 2 - Around * (LandWidth - Spacing),
               Spacing / 2 - Around * (LandDepth - Spacing), -1e6),
            At(LandWidth - Spacing / 2 + Around * (LandWidth - Spacing),
               LandDepth - Spacing / 2 + Around * (LandDepth - Spacing), 1e6)
            inverse
        }}
    }}
{}}}
)",
        number(lowest_border(heights)), skylight, goes_on ? kLandAround : kSidesAlone,
        under_sea ? kDeepGround : "    texture { MeanGround }\n");
}

}  // namespace cydonia::render::pov
