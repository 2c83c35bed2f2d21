#include "render/embree/preview_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/parallel.h"
#include "field/rgb.h"
#include "field/sample.h"
#include "render/cameras/view.h"
#include "render/ground/ground.h"
#include "render/passes/view.h"
#include "render/scene/water.h"
#include "render/sky/haze.h"
#include "render/sky/sky.h"

namespace cydonia::render {
namespace {

constexpr int kLongestPainted = 512;  // samples a side whose colours are computed
constexpr int kDomeHeight = 64;
constexpr double kAmongLeaves = 0.5;  // share of the visible sky that reaches things

// The land, reduced to the samples whose colours a preview can show.
Terrain painted(const Terrain& t) {
    const int w = t.heights.width(), h = t.heights.height();
    const int step = (std::max(w, h) + kLongestPainted - 1) / kLongestPainted;
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

// The share of unpolarised light that water reflects, by the cosine of incidence.
double fresnel(double cosine) {
    const double other =
        std::sqrt(1.0 - (1.0 - cosine * cosine) / (kWaterIndex * kWaterIndex));
    const double s = (cosine - kWaterIndex * other) / (cosine + kWaterIndex * other);
    const double p = (kWaterIndex * cosine - other) / (kWaterIndex * cosine + other);
    return 0.5 * (s * s + p * p);
}

}  // namespace

struct PreviewLand::Light {
    explicit Light(const Shot& shot)
        : sun(shot.sun),
          day(daylight(shot.sun, shot.options.sky)),
          dome(sky_dome(shot.sun, shot.options.sky, kDomeHeight)) {}

    Sun sun;
    Daylight day;
    Field<Rgb> dome;
};

class PreviewLand::Parts {
  public:
    Parts(const Shot& shot, const Terrain& terrain)
        : view(terrain, scenery_of(shot, terrain)),
          lowest(*std::ranges::min_element(view.terrain().heights)) {
        const Terrain small = painted(terrain);
        albedo = ground_albedo(small, shot.options.ground, 1);
        for (const Rgb& colour : albedo)
            mean = mean + (1.0 / static_cast<double>(albedo.size())) * colour;
        // The map is smooth: half the resolution is enough.
        const Field<float> rough =
            resized(small.heights, std::max(2, small.heights.width() / 2),
                    std::max(2, small.heights.height() / 2));
        sky_visible = sky_visibility(rough, terrain.width() / rough.width());
    }

    // The light of a sun and its sky, kept because consecutive shots often share it.
    const Light& light(const Shot& shot) {
        if (!light_ || !(light_->sun == shot.sun)) light_.emplace(shot);
        return *light_;
    }

    View view;
    float lowest;
    Field<Rgb> albedo;
    Rgb mean{};  // of the albedo
    Field<float> sky_visible;

  private:
    std::optional<Light> light_;
};

class PreviewLand::Picture {
  public:
    Picture(const Shot& shot, Parts& land)
        : shot_(shot),
          land_(land),
          light_(land.light(shot)),
          view_(land.view),
          rays_(shot.camera),
          to_sun_(direction_to(shot.sun)) {
        if (!has_haze(shot)) return;
        air_ = haze_light(shot);
        visibility_ =
            visibility(shot.options.sky, shot.options.haze, view_.terrain().width());
    }

    Field<Rgb> drawn() const {
        const Field<SeenPoint> points = view_.seen(rays_, shot_.smooth);
        const Field<float> shadow = view_.shadow(points, shot_.sun, View::SunAs::kPoint);
        Field<Rgb> frame(points.width(), points.height());
        parallel_for(frame.height(), 4, [&](int y) {
            for (int x = 0; x < frame.width(); ++x) {
                const SeenPoint& p = points(x, y);
                const Ray ray = rays_.through(x + 0.5, y + 0.5);
                frame(x, y) = natural(p, ray, 1.0 - shadow(x, y));
            }
        });
        return frame;
    }

  private:
    Rgb sky(const Vec3& way) const {
        const double azimuth = std::atan2(way.x, way.y);  // from north
        // POV-Ray wraps the image from +x over +z, which is north.
        const double turn = 0.25 - azimuth / (2.0 * std::numbers::pi);
        const double elevation = std::asin(std::clamp(way.z, -1.0, 1.0));
        return bilinear(
            light_.dome, (turn - std::floor(turn)) * light_.dome.width() - 0.5,
            (0.5 - elevation / std::numbers::pi) * light_.dome.height() - 0.5, true);
    }

    Rgb ground(const SeenPoint& p) const {
        if (p.surface == Surface::kThing) return view_.albedo(p);
        if (p.surface == Surface::kSide || p.surface == Surface::kOutskirts)
            return land_.mean;
        const Terrain& land = view_.terrain();
        if (p.surface == Surface::kWater && shot_.around == Around::kLevel &&
            !over_land(land, vec3_of(p.at)))
            return {};  // the open sea is deep
        const auto [east, north] = view_.on_land(p);
        return bilinear(land_.albedo, east / land.width() * land_.albedo.width() - 0.5,
                        (1.0 - north / land.depth()) * land_.albedo.height() - 0.5,
                        false);
    }

    bool is_flood(const SeenPoint& p) const {
        const auto& flood = shot_.options.water;
        return flood &&
               std::abs(p.at[2] - flood->level.in(view_.terrain().width())) < 0.01;
    }

    double visible(const SeenPoint& p) const {
        if (p.surface == Surface::kSide) return 0.5;
        if (p.surface != Surface::kLand && p.surface != Surface::kThing) return 1.0;
        const Terrain& land = view_.terrain();
        const auto [east, north] = view_.on_land(p);
        const double seen = cydonia::bilinear(
            land_.sky_visible, east / land.width() * land_.sky_visible.width() - 0.5,
            (1.0 - north / land.depth()) * land_.sky_visible.height() - 0.5);
        return p.surface == Surface::kThing ? kAmongLeaves * seen : seen;
    }

    // `sunlight` is the share of the sun's light that reaches the point.
    Rgb natural(const SeenPoint& p, const Ray& ray, double sunlight) const {
        if (p.surface == Surface::kSky)
            return sky(ray.direction);  // its image includes the haze
        const Vec3 normal = vec3_of(p.normal);
        const double lit = sunlight * std::max(0.0, dot(normal, to_sun_));
        const Rgb falling =
            lit * light_.day.sun + shot_.options.sky.fill * visible(p) * light_.day.sky;
        Rgb colour = ground(p);
        if (p.surface == Surface::kWater)
            colour = is_flood(p) ? kFloodColour : mixed(kWaterVeil, colour, kWaterClear);
        Rgb seen = colour * falling;
        if (p.surface == Surface::kWater) {
            const Vec3 mirrored{ray.direction.x, ray.direction.y,
                                std::abs(ray.direction.z)};
            seen = mixed(seen, sky(mirrored), fresnel(std::abs(ray.direction.z)));
        }
        return hazed(seen, ray, length(vec3_of(p.at) - ray.from));
    }

    Rgb hazed(const Rgb& colour, const Ray& ray, double distance) const {
        if (visibility_ <= 0.0) return colour;
        return mixed(air_, colour,
                     through_haze(visibility_, ray.from.z - land_.lowest, ray.direction.z,
                                  distance));
    }

    const Shot& shot_;
    const Parts& land_;
    const Light& light_;
    const View& view_;
    CameraRays rays_;
    Vec3 to_sun_;
    Rgb air_{};                // colour of the haze
    double visibility_ = 0.0;  // metres; 0: no haze
};

PreviewLand::PreviewLand(const Shot& shot, const Terrain& terrain)
    : parts_(std::make_unique<Parts>(shot, terrain)) {}
PreviewLand::~PreviewLand() = default;
PreviewLand::PreviewLand(PreviewLand&&) noexcept = default;

Field<Rgb> PreviewLand::frame(const Shot& shot) { return Picture(shot, *parts_).drawn(); }

Field<Rgb> preview_frame(const Shot& shot, const Terrain& terrain) {
    return PreviewLand(shot, terrain).frame(shot);
}

}  // namespace cydonia::render
