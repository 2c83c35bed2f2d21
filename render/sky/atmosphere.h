#pragma once

#include <array>

#include "field/field.h"
#include "field/sun.h"
#include "field/vec.h"
#include "render/sky/options.h"

namespace cydonia::render {

// Clear air under a distant light, computed by ray marching. Colours are linear Rec.709
// for a light whose colour outside the air is 1 (render/sky/sky.h).
class Atmosphere {
  public:
    Atmosphere(const Sun& sun, const SkyOptions& options);

    // Radiance from a direction above the horizon to an eye 500 m above the sea.
    Vec3 radiance(Vec3 direction) const;
    // The same of the air along the first `distance` metres only, divided by the share of
    // green light that this air takes away. The eye is `altitude` metres higher.
    Vec3 air_light(Vec3 direction, double distance, double altitude = 0.0) const;
    // Extinction of green light per metre at an altitude above the sea.
    static double extinction(const SkyOptions& options, double altitude);
    // Colour of the light itself at the eye: the mean over its disc, part of which may
    // have set.
    Vec3 sun_colour() const;

  private:
    struct Medium;
    struct Marched;
    static constexpr int kSunLevels = 48, kSunAngles = 256, kLevels = 16;

    static double altitude_of(int level);
    Medium medium(Vec3 point) const;
    Vec3 phase(const Medium& medium, double cosine) const;
    Vec3 transmittance(Vec3 from, Vec3 direction) const;
    Vec3 sunlight(Vec3 point) const;
    Vec3 further_light(Vec3 point) const;
    Vec3 multiple_scattering(double altitude) const;
    Marched march(Vec3 from, Vec3 direction, int steps, bool all_orders,
                  double reach) const;

    Sun place_;
    Vec3 sun_;
    // Coefficients of molecules and of aerosols at sea level, per metre.
    Vec3 rayleigh_, ozone_, aerosol_;
    Vec3 aerosol_albedo_, aerosol_g_;
    double aerosol_height_;  // metres
    double ground_albedo_;
    Field<Vec3> sunlight_{kSunLevels, kSunAngles};  // transmittance by level and sine
    std::array<Vec3, kLevels> multiple_{};
};

}  // namespace cydonia::render
