#include "render/ground/ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/noise.h"
#include "field/parallel.h"
#include "field/sample.h"

namespace cydonia::render {
namespace {

// Linear Rec.709 albedos, from light to dark of one material.
struct Material {
    Rgb light, dark;
};
constexpr Material kMeadow{{0.130f, 0.118f, 0.056f}, {0.078f, 0.088f, 0.036f}};
constexpr Material kEarth{{0.210f, 0.165f, 0.110f}, {0.150f, 0.115f, 0.074f}};
constexpr Material kScree{{0.230f, 0.200f, 0.165f}, {0.160f, 0.138f, 0.112f}};
constexpr Material kRock{{0.215f, 0.190f, 0.165f}, {0.105f, 0.092f, 0.080f}};
constexpr Material kRust{{0.200f, 0.145f, 0.105f}, {0.150f, 0.100f, 0.070f}};
constexpr Material kSand{{0.330f, 0.275f, 0.190f}, {0.255f, 0.210f, 0.145f}};
constexpr Material kSilt{{0.115f, 0.105f, 0.075f}, {0.080f, 0.075f, 0.055f}};
constexpr Material kSnow{{0.820f, 0.840f, 0.870f}, {0.740f, 0.770f, 0.820f}};

constexpr double kStrata = 45.0;  // metres of height that a pair of thick rock beds takes
constexpr double kWide = 200.0;   // wavelengths of the noise on every border, metres
constexpr double kNarrow = 20.0;
constexpr std::uint64_t kSeed = 0x6c616e64;

double smoothstep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

Rgb mix(const Rgb& a, const Rgb& b, double t) {
    const auto f = static_cast<float>(t);
    return {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])};
}
Rgb shade(const Material& m, double t) {
    return mix(m.dark, m.light, std::clamp(t, 0.0, 1.0));
}

// What water above the ground leaves of its colour (Beer-Lambert), straight down and up.
constexpr Rgb kAbsorption{0.20f, 0.075f, 0.065f};  // a metre, of coastal water
Rgb seen_through(double depth, Rgb ground) {
    for (std::size_t c = 0; c < 3; ++c)
        ground[c] *= static_cast<float>(std::exp(-2.0 * depth * kAbsorption[c]));
    return ground;
}

// Box means of (2 * radius + 1)^2 samples, clamped at the edges.
Field<float> blurred(const Field<float>& field, int radius) {
    const auto pass = [radius](const Field<float>& in, int dx, int dy) {
        Field<float> out(in.width(), in.height());
        parallel_for(in.height(), 16, [&](int y) {
            for (int x = 0; x < in.width(); ++x) {
                double sum = 0.0;
                for (int i = -radius; i <= radius; ++i)
                    sum += in(std::clamp(x + i * dx, 0, in.width() - 1),
                              std::clamp(y + i * dy, 0, in.height() - 1));
                out(x, y) = static_cast<float>(sum / (2 * radius + 1));
            }
        });
        return out;
    };
    return pass(pass(field, 1, 0), 0, 1);
}

// tan of the slope, and how far it faces north (-1 to 1).
struct Facing {
    Field<float> slope, north;
};

Facing facing_of(const Field<float>& h, double spacing) {
    Facing f{Field<float>(h.width(), h.height()), Field<float>(h.width(), h.height())};
    parallel_for(h.height(), 16, [&](int y) {
        for (int x = 0; x < h.width(); ++x) {
            const int w = std::max(x - 1, 0), e = std::min(x + 1, h.width() - 1);
            const int n = std::max(y - 1, 0), s = std::min(y + 1, h.height() - 1);
            const double gx = (h(e, y) - h(w, y)) / (spacing * (e - w));
            const double gy = (h(x, n) - h(x, s)) / (spacing * (s - n));
            const double slope = std::hypot(gx, gy);
            f.slope(x, y) = static_cast<float>(slope);
            f.north(x, y) = static_cast<float>(-gy / std::max(slope, 1e-6));
        }
    });
    return f;
}

double noise(double x, double y, double wavelength, std::uint64_t purpose) {
    return gradient_noise(x / wavelength, y / wavelength, kSeed + purpose) +
           0.5 * gradient_noise(2.03 * x / wavelength, 2.03 * y / wavelength,
                                kSeed + purpose + 1);
}

Field<float> noise_over(const Terrain& terrain, double wavelength,
                        std::uint64_t purpose) {
    Field<float> field(terrain.heights.width(), terrain.heights.height());
    parallel_for(field.height(), 16, [&](int y) {
        for (int x = 0; x < field.width(); ++x)
            field(x, y) = static_cast<float>(
                noise(x * terrain.spacing, y * terrain.spacing, wavelength, purpose));
    });
    return field;
}

// What decides a cell's ground but for the finest noise.
struct Relief {
    Field<float> height;
    Facing near;               // at a cell
    Field<float> far;          // slope at about 45 m
    Field<float> hollow;       // metres below the land around, at about 120 m
    Field<float> wide, wider;  // noise of kWide and three times it
    // The level of the water there or near, and how near: 1 in it, 0 from kBeach metres
    // on. Empty without water.
    Field<float> level, shore;
};

constexpr double kBeach = 50.0;

void set_shore(Relief& r, const Terrain& terrain, int radius) {
    const Field<float> depths = water_depths(terrain);
    if (std::ranges::max(depths) <= 0.0f) return;
    Field<float> wet(depths.width(), depths.height()), level = wet;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        wet[i] = depths[i] > 0.0f ? 1.0f : 0.0f;
        level[i] = depths[i] > 0.0f ? terrain.water[i] : 0.0f;
    }
    r.shore = blurred(wet, radius);
    r.level = blurred(level, radius);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        if (r.shore[i] > 0.0f) r.level[i] /= r.shore[i];
        if (depths[i] > 0.0f) r.level[i] = terrain.water[i];
        r.shore[i] = depths[i] > 0.0f ? 1.0f : std::min(1.0f, 4.0f * r.shore[i]);
    }
}

Relief relief_of(const Terrain& terrain) {
    const auto cells = [&](double metres) {
        return std::max(1, static_cast<int>(std::lround(metres / terrain.spacing / 2.0)));
    };
    Relief r;
    r.height = terrain.heights;
    r.near = facing_of(terrain.heights, terrain.spacing);
    r.far = facing_of(blurred(terrain.heights, cells(45.0)), terrain.spacing).slope;
    r.hollow = blurred(terrain.heights, cells(120.0));
    for (std::size_t i = 0; i < r.hollow.size(); ++i) r.hollow[i] -= terrain.heights[i];
    r.wide = noise_over(terrain, kWide, 1);
    r.wider = noise_over(terrain, 3.0 * kWide, 5);
    set_shore(r, terrain, cells(2.0 * kBeach));
    return r;
}

class Ground {
  public:
    Ground(const Terrain& terrain, const GroundOptions& options)
        : relief_(relief_of(terrain)),
          spacing_(terrain.spacing),
          rock_(std::tan(options.rock_slope[0])),
          all_rock_(std::tan(options.rock_slope[1])),
          snow_line_(options.snow_line.in(terrain.width())) {}

    // Albedo at a point of the grid, in cells.
    Rgb at(double x, double y) const {
        const double e = x * spacing_, s = y * spacing_;
        const double wide = bilinear(relief_.wide, x, y),
                     narrow = noise(e, s, kNarrow, 3);
        const double height = bilinear(relief_.height, x, y);
        const double hollow = bilinear(relief_.hollow, x, y);
        const double slope = 0.35 * bilinear(relief_.near.slope, x, y) +
                             0.65 * bilinear(relief_.far, x, y) + 0.07 * wide +
                             0.07 * narrow;

        const double patch = 0.5 + 0.5 * wide + 0.25 * narrow;
        const double moist = smoothstep(-0.3, 0.9,
                                        0.5 * bilinear(relief_.wider, x, y) +
                                            0.06 * hollow - 0.9 * slope + 0.25 * narrow);
        Rgb ground = mix(shade(kEarth, patch), shade(kMeadow, patch), moist);
        ground = mix(ground, shade(kScree, patch),
                     smoothstep(0.6 * rock_, 0.95 * rock_, slope));
        if (slope > rock_)
            ground = mix(ground, rock(height, wide, narrow),
                         smoothstep(rock_, all_rock_, slope));
        const double snowy = snow(x, y, height, hollow, slope, wide);
        if (relief_.shore.empty()) return mix(ground, shade(kSnow, patch), snowy);
        const double depth = bilinear(relief_.level, x, y) - height;
        const double washed = bilinear(relief_.shore, x, y) *
                              smoothstep(-4.0 - 2.0 * wide - narrow, 0.0, depth);
        ground = mix(ground, shade(kSnow, patch), snowy * (1.0 - washed));
        const Rgb sand =
            mix(shade(kSand, patch), shade(kSilt, patch), smoothstep(2.0, 25.0, depth));
        ground = mix(ground, sand, washed * (1.0 - smoothstep(rock_, all_rock_, slope)));
        return seen_through(std::max(0.0, depth), ground);
    }

  private:
    // Beds of rock by height, thick and thin, bent a little; here and there they do not
    // show.
    Rgb rock(double height, double wide, double narrow) const {
        const double bed = (height + 20.0 * wide + 4.0 * narrow) / kStrata;
        const double beds = gradient_noise(bed, 0.37, kSeed + 7) +
                            0.5 * gradient_noise(2.9 * bed, 0.37, kSeed + 8);
        const double shown = 0.35 + 0.65 * smoothstep(-0.4, 0.5, wide);
        const double rust =
            smoothstep(0.1, 0.6, gradient_noise(0.6 * bed, 2.5, kSeed + 9));
        const double band = 0.5 + 0.7 * shown * beds + 0.3 * narrow;
        return mix(shade(kRock, band), shade(kRust, band), 0.6 * rust);
    }

    double snow(double x, double y, double height, double hollow, double slope,
                double wide) const {
        const double north = bilinear(relief_.near.north, x, y);
        const double above = height - snow_line_ + 170.0 * north * std::min(slope, 1.0) +
                             5.0 * hollow + 60.0 * wide;
        const double holds = 1.0 - smoothstep(0.9, 1.19, slope);  // 42 to 50 degrees
        // Hardened: snow has an edge.
        return smoothstep(0.44, 0.60, smoothstep(-135.0, 135.0, above) * holds);
    }

    Relief relief_;
    double spacing_, rock_, all_rock_, snow_line_;
};

}  // namespace

Field<Rgb> ground_albedo(const Terrain& terrain, const GroundOptions& options,
                         int detail) {
    const Ground ground(terrain, options);
    Field<Rgb> albedo(terrain.heights.width() * detail,
                      terrain.heights.height() * detail);
    parallel_for(albedo.height(), 8, [&](int y) {
        for (int x = 0; x < albedo.width(); ++x)
            albedo(x, y) = ground.at((x + 0.5) / detail - 0.5, (y + 0.5) / detail - 0.5);
    });
    return albedo;
}

Field<float> sky_visibility(const Field<float>& heights, double spacing) {
    constexpr int kAzimuths = 16;
    constexpr double kFarthest = 160.0;  // cells; beyond, hills are low
    Field<float> visible(heights.width(), heights.height());
    parallel_for(heights.height(), 4, [&](int y) {
        for (int x = 0; x < heights.width(); ++x) {
            double sum = 0.0;
            for (int k = 0; k < kAzimuths; ++k) {
                const double a = 2.0 * std::numbers::pi * (k + 0.5) / kAzimuths;
                const double dx = std::cos(a), dy = std::sin(a);
                double steepest = 0.0;
                for (double t = 1.0; t < kFarthest; t = 1.25 * t + 0.5) {
                    const int i = static_cast<int>(std::floor(x + t * dx + 0.5));
                    const int j = static_cast<int>(std::floor(y + t * dy + 0.5));
                    if (!heights.contains(i, j)) break;
                    const double rise = heights(i, j) - heights(x, y);
                    steepest = std::max(steepest, rise / (t * spacing));
                }
                sum +=
                    1.0 / (1.0 + steepest * steepest);  // cosine squared of the horizon
            }
            visible(x, y) = static_cast<float>(sum / kAzimuths);
        }
    });
    return visible;
}

}  // namespace cydonia::render
