#pragma once

// Small grids for the tests of the constrained solver's parts.

#include <cstdint>

#include "field/field.h"
#include "field/length.h"
#include "field/random.h"
#include "field/terrain.h"
#include "field/vec.h"

namespace cydonia::pareidolia {

// Uniform in [-scale, scale).
inline Field<float> random_field(int width, int height, std::uint64_t seed,
                                 double scale = 1.0) {
    Field<float> field(width, height);
    for (std::size_t i = 0; i < field.size(); ++i)
        field[i] = static_cast<float>(scale * signed_unit(hash_of({seed, i})));
    return field;
}

inline void draw_box(Field<std::uint8_t>& target, int x0, int y0, int x1, int y1,
                     std::uint8_t value = 1) {
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) target(x, y) = value;
}

// A rectangle of shadow [x0, x1) x [y0, y1).
inline Field<std::uint8_t> box(int width, int height, int x0, int y0, int x1, int y1) {
    Field<std::uint8_t> target(width, height);
    draw_box(target, x0, y0, x1, y1);
    return target;
}

inline ShadowImage image_of(Field<std::uint8_t> target, double azimuth_degrees,
                            double elevation_degrees = 25.0) {
    ShadowImage image;
    image.name = "image";
    image.target = std::move(target);
    image.sun = {radians(azimuth_degrees), radians(elevation_degrees)};
    return image;
}

}  // namespace cydonia::pareidolia
