#pragma once

#include "field/field.h"
#include "field/sun.h"
#include "field/vec.h"
#include "render/sky/options.h"

namespace cydonia::render {

// A layer of cloud over the middle of the land: cumulus on a level base, or cirrus.
class CloudLayer {
  public:
    CloudLayer(Clouds kind, const Sun& sun);

    // The light of the clouds in a direction above the horizon under the given sunlight
    // and skylight (colours of render/sky/sky.h), and the share of the light behind them
    // that passes.
    struct Seen {
        Vec3 light;
        double through = 1.0;
    };
    Seen seen(Vec3 direction, Vec3 sunlight, Vec3 skylight) const;

    // The share of sunlight that reaches a point, metres from the middle of the land.
    // Cumulus only.
    double sunlight_through(Vec3 point) const;

  private:
    double thickness(double east, double north) const;  // 0 to 1
    double density(Vec3 point) const;

    Clouds kind_;
    Vec3 sun_;
    const Field<float>& map_;
};

// Whether clouds cast shadows on the land. Only broken clouds do: if the options say so,
// or by default when the land shows no shadow image. They do not under a sun so low that
// shadows would be endless.
bool throw_shadows(const SkyOptions& sky, const Sun& sun, bool holds_image);

}  // namespace cydonia::render
