#include "render/shadow/soft.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "field/parallel.h"

namespace cydonia::render {

namespace {

constexpr double kRadius = 0.53 / 2.0 * std::numbers::pi / 180.0;
constexpr int kPairs = 12;

// The middle, and pairs on a sunflower's spiral (Vogel 1979): each stands for as much of
// the disc, and any line through the middle halves them.
std::vector<Sun> disc(const Sun& sun) {
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<Sun> result{sun};
    for (int i = 0; i < kPairs; ++i)
        for (const double side : {-1.0, 1.0}) {
            const double r = side * kRadius * std::sqrt((i + 0.75) / kPairs);
            // On the horizon the lower part has set: its light comes level.
            const double up = std::max(1e-3, sun.elevation + r * std::sin(golden * i));
            result.push_back(
                {sun.azimuth + r * std::cos(golden * i) / std::cos(sun.elevation), up});
        }
    return result;
}

}  // namespace

Field<std::uint8_t> soft_shadow(const Caster& caster, const Sun& sun, int rays) {
    const std::vector<Sun> suns = disc(sun);
    Field<std::uint8_t> hidden = caster.shadow(suns.front(), rays);
    for (std::size_t i = 1; i < suns.size(); ++i) {
        const Field<std::uint8_t> cast = caster.shadow(suns[i], rays);
        parallel_for(cast.height(), 64, [&](int y) {
            for (int x = 0; x < cast.width(); ++x) hidden(x, y) += cast(x, y);
        });
    }
    const auto half = static_cast<std::uint8_t>(suns.size() / 2);
    for (auto& h : hidden) h = h > half;
    return hidden;
}

}  // namespace cydonia::render
