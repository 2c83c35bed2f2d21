#pragma once

#include "field/image.h"
#include "field/sun.h"
#include "field/vec.h"
#include "render/options.h"

namespace cydonia::render {

// One atmosphere for sun or moon, sky and haze, linear Rec.709, in one unit: what a white
// surface sends back. A light's colour is its irradiance over pi on a surface that faces
// it, the sky's its radiance; 1 is a white sheet in the sun outside the air (128 klx), by
// night in the full moon there (0.32 lx).
struct Daylight {
    Rgb sun;      // colour of a parallel light
    Rgb sky;      // mean radiance of the dome over a flat ground, cosine weighted: what
                  // ambient light is; without air what other slopes send back
    Rgb horizon;  // mean radiance at the horizon
};

Daylight daylight(const Sun& sun, const SkyOptions& options);

// What haze sends back toward a camera that looks to an azimuth (radians from north) and
// is as wide as `angle`: the light of the air on `distance` metres over the share of
// green light that it takes. Near air is bluer than the horizon, which `distance`
// reaches. A camera that looks down from `altitude` metres over the land sees no farther
// than the ground; `elevation` in radians.
Rgb air_light(const Sun& sun, const SkyOptions& options, double azimuth, double angle,
              double distance = 1e6, double elevation = radians(0.7),
              double altitude = 0.0);

// The sky as a latitude-longitude image, width = 2 * height, as POV-Ray's sky_sphere
// takes it (map_type 1): the top row is the zenith, below the horizon stands the
// horizon's colour; the sun's disc is left out. North lies where POV-Ray's +z is, see
// render/pov. Six times as high where there are clouds, which are finer.
Field<Rgb> sky_dome(const Sun& sun, const SkyOptions& options, int height);

// The share of sunlight that broken clouds let through to a level square `size` metres
// wide, its middle at `middle` (metres east, north and up of the middle of the land's
// lowest level), n x n, row 0 in the north.
Field<float> cloud_shadows(const Sun& sun, const Vec3& middle, double size, int n);

}  // namespace cydonia::render
