#include "render/embree/preview_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/parallel.h"
#include "field/rgb.h"
#include "field/sample.h"
#include "render/camera_view.h"
#include "render/ground/ground.h"
#include "render/passes/view.h"
#include "render/pov/pieces.h"
#include "render/sky/haze.h"
#include "render/sky/sky.h"

namespace cydonia::render {
namespace {

constexpr int kLongestGround = 512;  // samples a side that are painted
constexpr int kDomeHeight = 64;
constexpr double kWaterIndex = 1.33;
constexpr Rgb kWaterVeil{0.02f, 0.08f, 0.11f};  // as the .pov's water has it
constexpr float kWaterClear = 0.8f;
constexpr double kAmongLeaves = 0.5;  // of the sky that the place sees

Vec3 vec(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

// The land with so many samples as a preview can show the colours of.
Terrain painted(const Terrain& t) {
    const int w = t.heights.width(), h = t.heights.height();
    const int step = (std::max(w, h) + kLongestGround - 1) / kLongestGround;
    if (step <= 1) return t;
    const int columns = std::max(2, w / step), rows = std::max(2, h / step);
    Terrain small;
    small.spacing = t.width() / columns;
    small.heights = resized(t.heights, columns, rows);
    for (const auto& [name, mask] : t.masks)
        small.masks[name] = resized(mask, columns, rows);
    if (!t.water.empty()) {
        small.water = Field<float>(columns, rows);
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x)
                small.water(x, y) = t.water(std::min(x * step + step / 2, w - 1),
                                            std::min(y * step + step / 2, h - 1));
    }
    return small;
}

Rgb bilinear(const Field<Rgb>& map, double x, double y, bool wraps) {
    y = std::clamp(y, 0.0, map.height() - 1.0);
    if (!wraps) x = std::clamp(x, 0.0, map.width() - 1.0);
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(y);
    const auto column = [&](int at) {
        return wraps ? (at + map.width()) % map.width() : std::min(at, map.width() - 1);
    };
    const int j1 = std::min(j + 1, map.height() - 1);
    const int i0 = column(i), i1 = column(i + 1);
    return mixed(mixed(map(i0, j), map(i1, j), x - i),
                 mixed(map(i0, j1), map(i1, j1), x - i), y - j);
}

// Unpolarised light from air onto water.
double fresnel(double cosine) {
    const double other =
        std::sqrt(1.0 - (1.0 - cosine * cosine) / (kWaterIndex * kWaterIndex));
    const double s = (cosine - kWaterIndex * other) / (cosine + kWaterIndex * other);
    const double p = (kWaterIndex * cosine - other) / (kWaterIndex * cosine + other);
    return 0.5 * (s * s + p * p);
}

class Picture {
  public:
    Picture(const Shot& shot, const Terrain& terrain)
        : shot_(shot),
          view_(terrain, scenery_of(shot, terrain)),
          rays_(shot.camera),
          to_sun_(direction_to(shot.sun)) {
        low_ = *std::ranges::min_element(view_.terrain().heights);
        const Terrain small = painted(terrain);
        albedo_ = ground_albedo(small, shot.options.ground, 1);
        for (const Rgb& colour : albedo_)
            mean_ = mean_ + (1.0 / static_cast<double>(albedo_.size())) * colour;
        // Smooth enough for every other of those.
        const Field<float> rough =
            resized(small.heights, std::max(2, small.heights.width() / 2),
                    std::max(2, small.heights.height() / 2));
        sky_visible_ = sky_visibility(rough, terrain.width() / rough.width());
        light_ = daylight(shot.sun, shot.options.sky);
        dome_ = sky_dome(shot.sun, shot.options.sky, kDomeHeight);
        if (pov::has_haze(shot)) {
            air_ = pov::haze_light(shot);
            visibility_ =
                visibility(shot.options.sky, shot.options.haze, terrain.width());
        }
    }

    Field<Rgb> drawn() const {
        const Field<SeenPoint> points = view_.seen(rays_, shot_.smooth);
        const Field<float> shadow = view_.shadow(points, shot_.sun, View::SunAs::kPoint);
        Field<Rgb> frame(points.width(), points.height());
        parallel_for(frame.height(), 4, [&](int y) {
            for (int x = 0; x < frame.width(); ++x) {
                const SeenPoint& p = points(x, y);
                const Ray ray = rays_.through(x + 0.5, y + 0.5);
                frame(x, y) = natural(p, ray, shadow(x, y) > 0.0f);
            }
        });
        return frame;
    }

  private:
    Rgb sky(const Vec3& way) const {
        const double azimuth = std::atan2(way.x, way.y);  // from north
        // As POV-Ray wraps it: from +x over +z, which is north.
        const double turn = 0.25 - azimuth / (2.0 * std::numbers::pi);
        const double elevation = std::asin(std::clamp(way.z, -1.0, 1.0));
        return bilinear(dome_, (turn - std::floor(turn)) * dome_.width() - 0.5,
                        (0.5 - elevation / std::numbers::pi) * dome_.height() - 0.5,
                        true);
    }

    Rgb ground(const SeenPoint& p) const {
        if (p.surface == Surface::kThing) return view_.albedo(p);
        if (p.surface == Surface::kSide || p.surface == Surface::kOutskirts) return mean_;
        const Terrain& land = view_.terrain();
        if (p.surface == Surface::kWater && shot_.around == Around::kLevel &&
            !over_land(land, vec(p.at)))
            return {};  // the open sea is deep
        const auto [east, north] = view_.on_land(p);
        return bilinear(albedo_, east / land.width() * albedo_.width() - 0.5,
                        (1.0 - north / land.depth()) * albedo_.height() - 0.5, false);
    }

    double visible(const SeenPoint& p) const {
        if (p.surface == Surface::kSide) return 0.5;
        if (p.surface != Surface::kLand && p.surface != Surface::kThing) return 1.0;
        const Terrain& land = view_.terrain();
        const auto [east, north] = view_.on_land(p);
        const double seen = cydonia::bilinear(
            sky_visible_, east / land.width() * sky_visible_.width() - 0.5,
            (1.0 - north / land.depth()) * sky_visible_.height() - 0.5);
        return p.surface == Surface::kThing ? kAmongLeaves * seen : seen;
    }

    Rgb natural(const SeenPoint& p, const Ray& ray, bool shadowed) const {
        if (p.surface == Surface::kSky) return sky(ray.direction);  // it holds its air
        const Vec3 normal = vec(p.normal);
        const double lit = shadowed ? 0.0 : std::max(0.0, dot(normal, to_sun_));
        const Rgb falling =
            lit * light_.sun + shot_.options.sky.fill * visible(p) * light_.sky;
        Rgb colour = ground(p);
        if (p.surface == Surface::kWater) colour = mixed(kWaterVeil, colour, kWaterClear);
        Rgb seen = colour * falling;
        if (p.surface == Surface::kWater) {
            const Vec3 mirrored{ray.direction.x, ray.direction.y,
                                std::abs(ray.direction.z)};
            seen = mixed(seen, sky(mirrored), fresnel(std::abs(ray.direction.z)));
        }
        return hazed(seen, ray, length(vec(p.at) - ray.from));
    }

    Rgb hazed(const Rgb& colour, const Ray& ray, double distance) const {
        if (visibility_ <= 0.0) return colour;
        return mixed(
            air_, colour,
            through_haze(visibility_, ray.from.z - low_, ray.direction.z, distance));
    }

    const Shot& shot_;
    View view_;
    CameraRays rays_;
    Vec3 to_sun_;
    float low_ = 0.0f;
    Field<Rgb> albedo_, dome_;
    Field<float> sky_visible_;
    Daylight light_{};
    Rgb mean_{}, air_{};
    double visibility_ = 0.0;
};

}  // namespace

Field<Rgb> preview_frame(const Shot& shot, const Terrain& terrain) {
    return Picture(shot, terrain).drawn();
}

}  // namespace cydonia::render
