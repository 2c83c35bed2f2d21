#pragma once

#include "field/field.h"
#include "field/sun.h"
#include "field/vec.h"
#include "render/sky/options.h"

namespace cydonia::render {

// A layer of cloud over the middle of the land: heaps on a level base, or streaks of ice.
class CloudLayer {
  public:
    CloudLayer(Clouds kind, const Sun& sun);

    // What is seen of it in a direction above the horizon under sunlight and skylight, as
    // colours of render/sky/sky.h, and how much of what is behind.
    struct Seen {
        Vec3 light;
        double through = 1.0;
    };
    Seen seen(Vec3 direction, Vec3 sunlight, Vec3 skylight) const;

    // The share of sunlight that comes through to a point on level ground, metres from
    // the middle of the land, or above it. Heaps only.
    double sunlight_through(Vec3 point) const;

  private:
    double thickness(double east, double north) const;  // 0 to 1
    double density(Vec3 point) const;

    Clouds kind_;
    Vec3 sun_;
    const Field<float>& map_;
};

// Whether clouds throw shadows on the land: broken ones, where it is asked for, else
// where the land holds no shadow image; not from a sun so low that they would be endless.
bool throw_shadows(const SkyOptions& sky, const Sun& sun, bool holds_image);

}  // namespace cydonia::render
