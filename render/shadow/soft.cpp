#include "render/shadow/soft.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "field/parallel.h"

namespace cydonia::render {

namespace {

constexpr double kRadius = 0.53 / 2.0 * std::numbers::pi / 180.0;
constexpr int kRim = 4;

// The sun, moved from the disc's middle. A direction below the horizon becomes level,
// since that part of the disc has set.
Sun toward(const Sun& sun, double radius, double angle) {
    return {sun.azimuth + radius * std::cos(angle) / std::cos(sun.elevation),
            std::max(1e-3, sun.elevation + radius * std::sin(angle))};
}

// Cells where the directions of the disc's rim disagree, and their neighbours.
Field<std::uint8_t> penumbra(const Caster& caster, const Sun& sun) {
    const std::vector<Sun> rim = sun_rim(sun, 1.0);
    Field<std::uint8_t> dark = caster.shadow(sun, 1);
    for (int i = 0; i < kRim; ++i) {
        const Field<std::uint8_t> cast = caster.shadow(rim[std::size_t(i)], 1);
        parallel_for(cast.height(), 64, [&](int y) {
            for (int x = 0; x < cast.width(); ++x) dark(x, y) += cast(x, y);
        });
    }
    Field<std::uint8_t> result(dark.width(), dark.height());
    parallel_for(dark.height(), 16, [&](int y) {
        const int south = std::min(dark.height() - 1, y + 1);
        for (int x = 0; x < dark.width(); ++x) {
            const int east = std::min(dark.width() - 1, x + 1);
            for (int j = std::max(0, y - 1); j <= south; ++j)
                for (int i = std::max(0, x - 1); i <= east; ++i)
                    result(x, y) |= dark(i, j) != (dark(x, y) ? kRim + 1 : 0);
        }
    });
    return result;
}

}  // namespace

// Points of a sunflower spiral (Vogel 1979) and their opposites: each represents the same
// area of the disc, and every line through the middle has half of them on each side.
std::vector<Sun> sun_disc(const Sun& sun, int pairs) {
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<Sun> result;
    for (int i = 0; i < pairs; ++i)
        for (const double side : {-kRadius, kRadius})
            result.push_back(
                toward(sun, side * std::sqrt((i + 0.75) / pairs), golden * i));
    return result;
}

std::vector<Sun> sun_rim(const Sun& sun, double radii) {
    std::vector<Sun> result;
    for (int i = 0; i < kRim; ++i)
        result.push_back(toward(sun, radii * kRadius, 2.0 * std::numbers::pi * i / kRim));
    return result;
}

Field<std::uint8_t> hidden_sun(const Caster& caster, const Sun& sun, int rays) {
    const Field<std::uint8_t> where = penumbra(caster, sun);
    Field<std::uint8_t> hidden = caster.shadow(sun, rays);
    parallel_for(hidden.height(), 64, [&](int y) {
        for (int x = 0; x < hidden.width(); ++x)
            if (hidden(x, y) && !where(x / rays, y / rays))
                hidden(x, y) = kDiscDirections;
    });
    for (const Sun& part : sun_disc(sun, kDiscDirections / 2)) {
        const Field<std::uint8_t> cast = caster.shadow(part, rays, where);
        parallel_for(cast.height(), 64, [&](int y) {
            for (int x = 0; x < cast.width(); ++x)
                if (where(x / rays, y / rays)) hidden(x, y) += cast(x, y);
        });
    }
    return hidden;
}

Field<std::uint8_t> soft_shadow(const Caster& caster, const Sun& sun, int rays) {
    Field<std::uint8_t> shadow = hidden_sun(caster, sun, rays);
    for (auto& s : shadow) s = s > kDiscDirections / 2;
    return shadow;
}

}  // namespace cydonia::render
