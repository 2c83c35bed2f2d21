#include "render/sky/sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/parallel.h"
#include "render/sky/atmosphere.h"
#include "render/sky/clouds.h"

namespace cydonia::render {
namespace {

using std::numbers::pi;

// The share of light that passes an overcast, by IES 1984: 0.3 + 21 sin h of
// 0.8 + 15.5 sqrt(sin h) + 127.5 exp(-0.21 / sin h) sin h kilolux.
constexpr double kThroughOvercast = 0.2;

// Starlight and airglow, 0.17 mcd/m2 (Jensen et al., "A Physically-Based Night Sky
// Model", SIGGRAPH 2001, table 1), in the unit of a night.
constexpr double kNightGlow = 0.0017;

Rgb rgb(Vec3 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
double luminance(Vec3 v) { return 0.2126 * v.x + 0.7152 * v.y + 0.0722 * v.z; }

// The moon's light relative to that of a full moon by its phase angle: C. W. Allen,
// "Astrophysical Quantities" (1976), section 66.
double phase_light(double lit_share) {
    const double angle = std::acos(std::clamp(2.0 * lit_share - 1.0, -1.0, 1.0));
    const double a = angle * 180.0 / pi;
    return std::pow(10.0, -0.4 * (0.026 * a + 4e-9 * a * a * a * a));
}

// The colour of the light outside the air. By moonlight the eye sees little colour and a
// blue tint: Jensen et al. 2001, section 5, shift white to the chromaticity (0.25, 0.25).
// For a film half of that shift is enough; luminance is kept. A fifth of the sky's own
// colour is left.
constexpr Vec3 kMoonlight{0.842, 1.012, 1.345};
constexpr double kNightSaturation = 0.2;

// The colour of an overcast, 6900 K, relative to the sun outside the air.
constexpr Vec3 kOvercastColour{0.961, 1.007, 1.046};

// The share of light that slopes send to one another on land without air.
constexpr double kSlopesSeen = 0.1;

class Sky {
  public:
    Sky(const Sun& sun, const SkyOptions& options)
        : air_(sun, options), sine_(std::sin(sun.elevation)), options_(options) {
        if (night()) {
            light_ = phase_light(options.moon) * kMoonlight;
            glow_ = kNightGlow * kMoonlight;
        }
        if (!options.air) return;
        clear_ = mean_of_clear();
        if (options.clouds == Clouds::kOvercast) {
            const Vec3 above =
                clear_ + std::max(sine_, 0.0) * product(light_, faded(air_.sun_colour()));
            // Thick cloud mixes sun and sky to a uniform grey.
            overcast_ = kThroughOvercast * luminance(above) *
                        (night() ? kMoonlight : kOvercastColour);
        }
    }

    bool night() const { return options_.moon > 0.0; }
    bool overcast() const { return options_.air && options_.clouds == Clouds::kOvercast; }
    Vec3 sun() const {
        if (!options_.air) return sine_ > 0.0 ? light_ : Vec3{};
        return overcast() ? Vec3{} : product(light_, faded(air_.sun_colour()));
    }
    // Cosine-weighted mean radiance over level ground.
    Vec3 mean() const {
        if (!options_.air)
            return kSlopesSeen * options_.ground_albedo * std::max(sine_, 0.0) * light_;
        return overcast() ? overcast_ : clear_;
    }

    // CIE's standard overcast: three times as bright overhead as at the horizon.
    Vec3 radiance(Vec3 direction) const {
        if (!options_.air) return {};
        return overcast() ? 3.0 / 7.0 * (1.0 + 2.0 * direction.z) * overcast_
                          : seen(air_.radiance(direction));
    }

    // The light of the air along a way, divided by the share of light that it takes away.
    Vec3 haze(Vec3 direction, double distance, double altitude) const {
        if (!options_.air || overcast())
            return radiance({direction.x, direction.y, std::max(direction.z, 0.0)});
        return seen(air_.air_light(direction, distance, altitude));
    }

  private:
    // Colours of the air, as the eye sees them by night.
    Vec3 faded(Vec3 light) const {
        if (!night()) return light;
        const double grey = luminance(light);
        return kNightSaturation * light +
               (1.0 - kNightSaturation) * Vec3{grey, grey, grey};
    }
    Vec3 seen(Vec3 light) const { return product(light_, faded(light)) + glow_; }

    Vec3 mean_of_clear() const {
        constexpr int kSpokes = 48, kRings = 24;
        Field<Vec3> light(kSpokes, kRings);
        parallel_for(kRings, [&](int y) {
            const double z = std::sqrt((y + 0.5) / kRings), r = std::sqrt(1.0 - z * z);
            for (int x = 0; x < kSpokes; ++x) {
                const double a = 2.0 * pi * (x + 0.5) / kSpokes;
                light(x, y) = seen(air_.radiance({r * std::cos(a), r * std::sin(a), z}));
            }
        });
        Vec3 sum;
        for (const Vec3& v : light) sum = sum + v;
        return 1.0 / (kSpokes * kRings) * sum;
    }

    Atmosphere air_;
    double sine_;
    SkyOptions options_;
    Vec3 light_{1.0, 1.0, 1.0}, glow_, clear_, overcast_;
};

Vec3 direction_at(double azimuth, double elevation) {
    return direction_to({azimuth, elevation});
}

// The direction of a pixel of the dome above the horizon; columns run from east to north.
Vec3 direction_of(int x, int y, int width, int height) {
    return direction_at(pi / 2.0 - 2.0 * pi * (x + 0.5) / width,
                        pi / 2.0 * (1.0 - (y + 0.5) / height));
}

// Over directions side by side.
template <class Light>
Vec3 mean_of(double azimuth, double angle, double elevation, const Light& light) {
    constexpr int kAcross = 16;
    Vec3 sum;
    for (int i = 0; i < kAcross; ++i)
        sum = sum + light(direction_at(azimuth + angle * ((i + 0.5) / kAcross - 0.5),
                                       elevation));
    return 1.0 / kAcross * sum;
}

constexpr int kCloudDetail = 6;  // pixels for each pixel of a clear sky, each way
constexpr double kDegree = pi / 180.0;

// The rows above the horizon; radiance is smooth away from the sun.
Field<Rgb> upper_dome(const Sky& sky, int width, int height) {
    Field<Rgb> dome(width, height);
    parallel_for(height, [&](int y) {
        for (int x = 0; x < width; ++x)
            dome(x, y) = rgb(sky.radiance(direction_of(x, y, width, height)));
    });
    return dome;
}

// The interpolated sky and the clouds in front of it, which the air veils far away.
void draw_clouds(const CloudLayer& clouds, const Sky& sky, const Field<Rgb>& clear,
                 Field<Rgb>& dome, int height) {
    const double scale = static_cast<double>(clear.width()) / dome.width();
    const Vec3 sunlight = sky.sun(), skylight = sky.mean();
    parallel_for(height, [&](int y) {
        const double v = std::clamp((y + 0.5) * scale - 0.5, 0.0, clear.height() - 1.001);
        const int j = static_cast<int>(v);
        for (int x = 0; x < dome.width(); ++x) {
            const double u = (x + 0.5) * scale - 0.5 + clear.width();
            const int i = static_cast<int>(u) % clear.width(),
                      next = (i + 1) % clear.width();
            const double f = u - std::floor(u), g = v - j;
            const Vec3 behind = (1.0 - g) * ((1.0 - f) * vec3_of(clear(i, j)) +
                                             f * vec3_of(clear(next, j))) +
                                g * ((1.0 - f) * vec3_of(clear(i, j + 1)) +
                                     f * vec3_of(clear(next, j + 1)));
            const Vec3 toward = direction_of(x, y, dome.width(), height);
            const auto cloud = clouds.seen(toward, sunlight, skylight);
            const double near = std::exp(-0.035 / std::max(toward.z, 1e-3));
            dome(x, y) =
                rgb(behind + near * (cloud.light + (cloud.through - 1.0) * behind));
        }
    });
}

}  // namespace

Daylight daylight(const Sun& sun, const SkyOptions& options) {
    const Sky sky(sun, options);
    return {rgb(sky.sun()), rgb(sky.mean()),
            rgb(mean_of(0.0, 2.0 * pi, 2.0 * kDegree,
                        [&](Vec3 way) { return sky.radiance(way); }))};
}

Rgb air_light(const Sun& sun, const SkyOptions& options, double azimuth, double angle,
              double distance, double elevation, double altitude) {
    const Sky sky(sun, options);
    return rgb(mean_of(azimuth, angle, elevation,
                       [&](Vec3 way) { return sky.haze(way, distance, altitude); }));
}

Field<Rgb> sky_dome(const Sun& sun, const SkyOptions& options, int height) {
    const Sky sky(sun, options);
    const bool clouded = options.air && (options.clouds == Clouds::kCirrus ||
                                         options.clouds == Clouds::kBroken);
    const Field<Rgb> above = upper_dome(sky, 2 * height, height / 2);
    if (clouded) height *= kCloudDetail;
    const int upper = height / 2;
    Field<Rgb> dome(2 * height, height);
    if (clouded)
        draw_clouds(CloudLayer(options.clouds, sun), sky, above, dome, upper);
    else
        std::copy(above.begin(), above.end(), dome.begin());
    for (int y = upper; y < height; ++y)
        std::copy_n(dome.row(upper - 1).begin(), 2 * height, dome.row(y).begin());
    return dome;
}

Field<float> cloud_shadows(const Sun& sun, const Vec3& middle, double size, int n) {
    const CloudLayer clouds(Clouds::kBroken, sun);
    Field<float> through(n, n);
    parallel_for(n, 8, [&](int y) {
        for (int x = 0; x < n; ++x) {
            const Vec3 from{size * ((x + 0.5) / n - 0.5), size * (0.5 - (y + 0.5) / n),
                            0.0};
            through(x, y) = static_cast<float>(clouds.sunlight_through(middle + from));
        }
    });
    return through;
}

}  // namespace cydonia::render
