// Clouds as a map of how thick they are on a level base, marched toward the eye and
// toward the sun. Light scattered many times in them: M. Wrenninge, C. Kulla and
// V. Lundqvist, "Oz: The Great and Volumetric" (SIGGRAPH Talks 2013): octaves of single
// scattering, each dimmer, deeper and less forward.
#include "render/sky/clouds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/noise.h"
#include "field/parallel.h"
#include "field/smoothstep.h"

namespace cydonia::render {
namespace {

using std::numbers::pi;

constexpr int kMap = 1536;          // samples a side
constexpr double kReach = 30e3;     // metres from its middle to its sides; then mirrored
constexpr double kPlanet = 6360e3;  // radius
constexpr double kHeapBase = 1800.0, kHeapHeight = 1300.0, kHeapExtinction = 0.012;
constexpr double kIceBase = 8000.0, kIceDepth = 0.5;
constexpr double kShade = 0.15;  // share of the extinction that takes light from the land
constexpr double kForward = 0.8;  // asymmetry of Henyey and Greenstein's phase function
constexpr double kLowestShading =
    radians(3.0);  // the lowest sun that casts shadows of clouds

double henyey_greenstein(double cosine, double g) {
    return (1.0 - g * g) / (4.0 * pi * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}

// Light scattered at a cosine from the sun, below an optical depth.
class Scattered {
  public:
    explicit Scattered(double cosine) {
        double share = 1.0;
        for (double& octave : octaves_) {
            octave = pi * share * henyey_greenstein(cosine, kForward * share);
            share *= 0.5;
        }
    }
    double below(double depth) const {
        double sum = 0.0, share = 1.0;
        for (const double octave : octaves_) {
            sum += octave * std::exp(-depth * share * share);
            share *= 0.5;
        }
        return sum;
    }

  private:
    double octaves_[4];
};

double octaves(double x, double y, int count, std::uint64_t seed) {
    double sum = 0.0, size = 1.0;
    for (int i = 0; i < count; ++i, size *= 0.5)
        sum += size * gradient_noise(x / size, y / size, seed + i);
    return sum;
}

// Cumulus: heaps one or two kilometres wide in groups of about ten, rounded above.
float heap(double x, double y) {
    const double group = octaves(x / 11e3, y / 11e3, 2, 71);
    const double one = octaves(x / 2600.0, y / 2600.0, 6, 72);
    return static_cast<float>(
        std::sqrt(std::clamp(1.5 * (one + 0.7 * group - 0.12), 0.0, 1.0)));
}

// Cirrus: streaks that the wind has drawn out and bent.
float streak(double x, double y) {
    const double bend = 5e3 * gradient_noise(x / 21e3, y / 21e3, 81);
    const double along = (0.8 * x + 0.6 * y) / 26e3;
    const double across = (0.8 * y - 0.6 * x + bend) / 4.2e3;
    const double where = smoothstep(-0.25, 0.5, octaves(x / 19e3, y / 19e3, 2, 82));
    return static_cast<float>(where *
                              smoothstep(-0.3, 0.8, octaves(along, across, 7, 83)));
}

template <class Thickness>
Field<float> map_of(const Thickness& thickness) {
    Field<float> map(kMap, kMap);
    parallel_for(kMap, 8, [&](int j) {
        const double y = kReach * (2.0 * j / (kMap - 1) - 1.0);
        for (int i = 0; i < kMap; ++i)
            map(i, j) = thickness(kReach * (2.0 * i / (kMap - 1) - 1.0), y);
    });
    return map;
}
// The map does not depend on the sun. It is most of the work of a sky and drawn once.
const Field<float>& heaps() {
    static const Field<float> map = map_of(heap);
    return map;
}
const Field<float>& streaks() {
    static const Field<float> map = map_of(streak);
    return map;
}

double mirrored(double metres) {
    double at = std::abs(metres + kReach);
    if (at >= 4.0 * kReach) at = std::fmod(at, 4.0 * kReach);
    return std::min(at, 4.0 * kReach - at) / (2.0 * kReach) * (kMap - 1);
}

// The distance at which a ray from the ground reaches an altitude of `up` above a round
// earth.
double distance_to(double sine, double up) {
    const double b = kPlanet * sine;
    return std::sqrt(b * b + 2.0 * kPlanet * up + up * up) - b;
}

}  // namespace

CloudLayer::CloudLayer(Clouds kind, const Sun& sun)
    : kind_(kind),
      sun_(direction_to(sun)),
      map_(kind == Clouds::kCirrus ? streaks() : heaps()) {}

double CloudLayer::thickness(double east, double north) const {
    const double x = mirrored(east), y = mirrored(north);
    const int i = std::min(static_cast<int>(x), kMap - 2);
    const int j = std::min(static_cast<int>(y), kMap - 2);
    const double u = x - i, v = y - j;
    return (1.0 - v) * ((1.0 - u) * map_(i, j) + u * map_(i + 1, j)) +
           v * ((1.0 - u) * map_(i, j + 1) + u * map_(i + 1, j + 1));
}

// Density of cumulus with flat bases: z is 0 at the base and 1 at the highest top.
double CloudLayer::density(Vec3 p) const {
    if (p.z < 0.0 || p.z > 1.0) return 0.0;
    return smoothstep(0.0, 0.08, p.z) * smoothstep(0.0, 0.18, thickness(p.x, p.y) - p.z);
}

double CloudLayer::sunlight_through(Vec3 point) const {
    constexpr int kSteps = 24;
    const double up = std::max(sun_.z, 0.02), step = kHeapHeight / up / kSteps;
    double depth = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double t = (kHeapBase - point.z) / up + (i + 0.5) * step;
        depth +=
            step * kHeapExtinction *
            density({point.x + t * sun_.x, point.y + t * sun_.y, (i + 0.5) / kSteps});
    }
    // Light scattered forward reaches the ground too.
    return std::exp(-kShade * depth);
}

CloudLayer::Seen CloudLayer::seen(Vec3 direction, Vec3 sunlight, Vec3 skylight) const {
    const Scattered scattered(dot(direction, sun_));
    if (kind_ == Clouds::kCirrus) {
        const double far = distance_to(direction.z, kIceBase);
        const double depth = kIceDepth * thickness(far * direction.x, far * direction.y) *
                             std::min(kIceBase > 0.0 ? far / kIceBase : 1.0, 3.0);
        const double through = std::exp(-depth);
        return {(1.0 - through) * (scattered.below(0.3) * sunlight + skylight), through};
    }
    constexpr int kSteps = 96, kTowardSun = 5;  // fewer show as steps
    const double near = distance_to(direction.z, kHeapBase);
    const double far = distance_to(direction.z, kHeapBase + kHeapHeight);
    const double step = (far - near) / kSteps;
    const double up = std::max(sun_.z, 0.05);
    Seen seen;
    for (int i = 0; i < kSteps && seen.through > 0.01; ++i) {
        const double t = near + (i + 0.5) * step;
        const Vec3 p{t * direction.x, t * direction.y, (i + 0.5) / kSteps};
        const double here = density(p);
        if (here <= 0.0) continue;
        double depth = 0.0;
        for (int j = 0; j < kTowardSun; ++j) {
            // Steps double: what is near shades most finely.
            const double a = 40.0 * (std::exp2(j) - 0.5), width = 40.0 * std::exp2(j);
            depth +=
                width * kHeapExtinction *
                density({p.x + a * sun_.x, p.y + a * sun_.y, p.z + a * up / kHeapHeight});
        }
        const double passed = std::exp(-step * kHeapExtinction * here);
        seen.light = seen.light + seen.through * (1.0 - passed) *
                                      (scattered.below(depth) * sunlight +
                                       (0.5 + 0.5 * p.z) * skylight);
        seen.through *= passed;
    }
    return seen;
}

bool throw_shadows(const SkyOptions& sky, const Sun& sun, bool holds_image) {
    return sky.air && sky.clouds == Clouds::kBroken &&
           sky.cloud_shadows.value_or(!holds_image) && sun.elevation >= kLowestShading;
}

}  // namespace cydonia::render
