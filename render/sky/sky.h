#pragma once

#include "field/image.h"
#include "field/sun.h"
#include "field/vec.h"
#include "render/options.h"

namespace cydonia::render {

// One atmosphere for sun or moon, sky and haze. Colours are linear Rec.709 in one unit,
// the radiance of a white surface: a light's colour is its irradiance on a surface that
// faces it divided by pi, and the sky's colour is its radiance. 1 is a white sheet in the
// sun outside the air (128 klx), or by night under the full moon there (0.32 lx).
struct Daylight {
    Rgb sun;      // colour of a parallel light
    Rgb sky;      // mean radiance of the dome over a flat ground, cosine weighted: what
                  // ambient light is; without air what other slopes send back
    Rgb horizon;  // mean radiance at the horizon
};

Daylight daylight(const Sun& sun, const SkyOptions& options);

// The colour of the haze for a camera that looks to an azimuth (radians from north) with
// a field of view of `angle`: the light of the air over `distance` metres, divided by the
// share of green light that it takes away. Near air is bluer than the horizon. A camera
// that looks down from `altitude` metres above the land sees no farther than the ground;
// `elevation` is in radians.
Rgb air_light(const Sun& sun, const SkyOptions& options, double azimuth, double angle,
              double distance = 1e6, double elevation = radians(0.7),
              double altitude = 0.0);

// The sky as a latitude-longitude image, width = 2 * height, for POV-Ray's sky_sphere
// (map_type 1). The top row is the zenith, and rows below the horizon have the horizon's
// colour. North is POV-Ray's +z (render/pov). The sun's disc is left out. With clouds,
// which are finer, the image is six times as high.
Field<Rgb> sky_dome(const Sun& sun, const SkyOptions& options, int height);

// The share of sunlight that broken clouds let through to a level square `size` metres
// wide, as n x n values, row 0 in the north. Its middle is `middle` metres east, north
// and up of the middle of the land at its lowest height.
Field<float> cloud_shadows(const Sun& sun, const Vec3& middle, double size, int n);

}  // namespace cydonia::render
