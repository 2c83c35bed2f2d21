// A clear sky by ray marching: Rayleigh and Mie scattering and ozone, single scattering
// plus the isotropic estimate of all further ones of S. Hillaire, "A Scalable and
// Production Ready Sky and Atmosphere Rendering Technique" (EGSR 2020), sections 4
// and 5.5; coefficients as in his table 1, but for the aerosols, whose amount and colour
// follow turbidity as in A. Preetham, P. Shirley and B. Smits, "A Practical Analytic
// Model for Daylight" (SIGGRAPH 1999), appendix A.1: his table has a twentieth of a clear
// day's.
#include "render/sky/atmosphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/parallel.h"

namespace cydonia::render {
namespace {

using std::numbers::pi;

constexpr double kGround = 6360e3, kTop = 6460e3;  // radii, metres
constexpr double kEye = 500.0;                     // altitude of the observer, metres
constexpr double kRayleighHeight = 8000.0, kAerosolHeight = 1200.0;
constexpr Vec3 kRayleigh{5.802e-6, 13.558e-6, 33.1e-6};
constexpr Vec3 kOzone{0.650e-6, 1.881e-6, 0.085e-6};
constexpr Vec3 kWavelengths{0.68, 0.55, 0.44};  // of the coefficients, micrometres
constexpr double kAerosolAlbedo = 0.9, kAerosolG = 0.8;
// Mars: a hundredth of the air, dust as high as the air reaches, red thrown less forward
// than blue, so that a low sun has a bluish glow (J. Ehlers et al., "Blue Moons and
// Martian sunsets", Applied Optics 2014).
constexpr double kThinAir = 0.01, kDustHeight = 11e3;
constexpr Vec3 kDustG{0.72, 0.76, 0.82};
constexpr double kEndless = 1e9;
constexpr double kLowestTabled = -0.2;       // sine of its elevation in the table
constexpr double kDisc = 0.53 / 180.0 * pi;  // across

double square(double v) { return v * v; }
Vec3 exp_of(Vec3 a) { return {std::exp(a.x), std::exp(a.y), std::exp(a.z)}; }
Vec3 grey(double v) { return {v, v, v}; }
Vec3 share(Vec3 a, Vec3 b) {
    const auto divide = [](double u, double v) { return v > 0.0 ? u / v : 0.0; };
    return {divide(a.x, b.x), divide(a.y, b.y), divide(a.z, b.z)};
}

// Angstrom's law gives the optical depth of all aerosols overhead; dividing by their
// scale height gives the coefficient. Grains of dust are larger than a wavelength and dim
// all colours equally.
Vec3 aerosol_of(double turbidity, bool dust) {
    const double beta = std::max(0.0, 0.04608 * turbidity - 0.04586);
    const auto extinction = [&](double wavelength) {
        return dust ? beta * std::pow(kWavelengths.y, -1.3) / kDustHeight
                    : beta * std::pow(wavelength, -1.3) / kAerosolHeight;
    };
    return {extinction(kWavelengths.x), extinction(kWavelengths.y),
            extinction(kWavelengths.z)};
}

// The distance at which a ray from `origin` (the planet's centre is 0) leaves the air,
// and whether it ends at the ground.
struct Exit {
    double distance;
    bool ground;
};

Exit exit_of(Vec3 origin, Vec3 direction) {
    const double b = dot(origin, direction), r2 = dot(origin, origin);
    const double under = b * b - r2 + kGround * kGround;
    if (under > 0.0 && b < 0.0) return {-b - std::sqrt(under), true};
    return {-b + std::sqrt(b * b - r2 + kTop * kTop), false};
}

}  // namespace

// The scattering and extinction of the air at a point.
struct Atmosphere::Medium {
    Vec3 rayleigh, aerosol, extinction;
    Vec3 scattering() const { return rayleigh + aerosol; }
};

struct Atmosphere::Marched {
    Vec3 light;    // radiance, for an irradiance of pi by the sun
    Vec3 feeding;  // the share of uniform light that comes back: f_ms
    Vec3 passed;   // transmittance for light from behind
};

Atmosphere::Atmosphere(const Sun& sun, const SkyOptions& options)
    : place_(sun),
      sun_(direction_to(sun)),
      rayleigh_(options.dust ? kThinAir * kRayleigh : kRayleigh),
      ozone_(options.dust ? Vec3{} : kOzone),
      aerosol_(aerosol_of(options.turbidity, options.dust.has_value())),
      aerosol_albedo_(grey(kAerosolAlbedo)),
      aerosol_g_(options.dust ? kDustG : grey(kAerosolG)),
      aerosol_height_(options.dust ? kDustHeight : kAerosolHeight),
      ground_albedo_(options.ground_albedo) {
    if (const auto& dust = options.dust)
        aerosol_albedo_ = {(*dust)[0], (*dust)[1], (*dust)[2]};
    parallel_for(kSunAngles, [&](int j) {
        for (int i = 0; i < kSunLevels; ++i) {
            const double z = kLowestTabled + (1.0 - kLowestTabled) * j / (kSunAngles - 1);
            const double altitude = (kTop - kGround) * square(i / (kSunLevels - 1.0));
            sunlight_(i, j) = transmittance({0.0, 0.0, kGround + altitude},
                                            {std::sqrt(1.0 - z * z), 0.0, z});
        }
    });
    for (int i = 0; i < kLevels; ++i) multiple_[i] = multiple_scattering(altitude_of(i));
}

Vec3 Atmosphere::radiance(Vec3 direction) const {
    return march({0.0, 0.0, kGround + kEye}, direction, 48, true, kEndless).light;
}

Vec3 Atmosphere::air_light(Vec3 direction, double distance, double altitude) const {
    const Marched way =
        march({0.0, 0.0, kGround + kEye + altitude}, direction, 48, true, distance);
    return 1.0 / std::max(1e-6, 1.0 - way.passed.y) * way.light;
}

double Atmosphere::extinction(const SkyOptions& options, double altitude) {
    const bool dust = options.dust.has_value();
    return std::exp(-altitude / kRayleighHeight) * (dust ? kThinAir : 1.0) * kRayleigh.y +
           std::exp(-altitude / (dust ? kDustHeight : kAerosolHeight)) *
               aerosol_of(options.turbidity, dust).y;
}

Vec3 Atmosphere::sun_colour() const {
    constexpr int kBands = 9;
    Vec3 sum;
    double weights = 0.0;
    for (int i = 0; i < kBands; ++i) {
        const double up = kDisc * ((i + 0.5) / kBands - 0.5);
        const Vec3 toward = direction_to({place_.azimuth, place_.elevation + up});
        const double width = std::sqrt(1.0 - square((2.0 * i + 1.0) / kBands - 1.0));
        sum = sum + width * transmittance({0.0, 0.0, kGround + kEye}, toward);
        weights += width;
    }
    return 1.0 / weights * sum;
}

Vec3 Atmosphere::transmittance(Vec3 from, Vec3 direction) const {
    const Exit exit = exit_of(from, direction);
    if (exit.ground) return {};
    constexpr int kSteps = 32;
    Vec3 depth;
    for (int i = 0; i < kSteps; ++i) {
        // Steps grow with distance, since the air is thin far away.
        const double a = static_cast<double>(i) / kSteps, b = (i + 1.0) / kSteps;
        const double t0 = exit.distance * a * a, t1 = exit.distance * b * b;
        depth =
            depth + (t1 - t0) * medium(from + (0.5 * (t0 + t1)) * direction).extinction;
    }
    return exp_of(-1.0 * depth);
}

double Atmosphere::altitude_of(int level) {
    return (kTop - kGround) * square(level / (kLevels - 1.0));
}

// Transmittance toward the sun, from a table: the march asks for it millions of
// times.
Vec3 Atmosphere::sunlight(Vec3 p) const {
    const double radius = length(p);
    const double level =
        std::sqrt(std::clamp((radius - kGround) / (kTop - kGround), 0.0, 1.0)) *
        (kSunLevels - 1);
    const double angle =
        std::clamp((dot(p, sun_) / radius - kLowestTabled) / (1.0 - kLowestTabled), 0.0,
                   1.0) *
        (kSunAngles - 1);
    const int i = std::min(static_cast<int>(level), kSunLevels - 2);
    const int j = std::min(static_cast<int>(angle), kSunAngles - 2);
    const double u = level - i, v = angle - j;
    return (1.0 - v) * ((1.0 - u) * sunlight_(i, j) + u * sunlight_(i + 1, j)) +
           v * ((1.0 - u) * sunlight_(i, j + 1) + u * sunlight_(i + 1, j + 1));
}

Atmosphere::Medium Atmosphere::medium(Vec3 p) const {
    const double altitude = std::max(length(p) - kGround, 0.0);
    Medium m;
    m.rayleigh = std::exp(-altitude / kRayleighHeight) * rayleigh_;
    const Vec3 aerosol = std::exp(-altitude / aerosol_height_) * aerosol_;
    m.aerosol = product(aerosol_albedo_, aerosol);
    const double ozone = std::max(0.0, 1.0 - std::abs(altitude - 25e3) / 15e3);
    m.extinction = m.rayleigh + aerosol + ozone * ozone_;
    return m;
}

// Rayleigh's phase function and Cornette-Shanks' for haze; both average 1 / 4 pi.
Vec3 Atmosphere::phase(const Medium& m, double cosine) const {
    const double rayleigh = 3.0 / (16.0 * pi) * (1.0 + cosine * cosine);
    const auto mie = [&](double g) {
        const double g2 = g * g;
        return 3.0 / (8.0 * pi) * (1.0 - g2) * (1.0 + cosine * cosine) /
               ((2.0 + g2) * std::pow(1.0 + g2 - 2.0 * g * cosine, 1.5));
    };
    return rayleigh * m.rayleigh +
           product({mie(aerosol_g_.x), mie(aerosol_g_.y), mie(aerosol_g_.z)}, m.aerosol);
}

// All orders beyond the first at an altitude (Hillaire 2020, section 5.5).
Vec3 Atmosphere::further_light(Vec3 p) const {
    const double altitude = std::clamp(length(p) - kGround, 0.0, kTop - kGround);
    const double at = std::sqrt(altitude / (kTop - kGround)) * (kLevels - 1);
    const int i = std::min(static_cast<int>(at), kLevels - 2);
    const double f = at - i;
    return (1.0 - f) * multiple_[i] + f * multiple_[i + 1];
}

Atmosphere::Marched Atmosphere::march(Vec3 from, Vec3 direction, int steps,
                                      bool all_orders, double reach) const {
    Exit exit = exit_of(from, direction);
    if (reach < exit.distance) exit = {reach, false};
    const double cosine = dot(direction, sun_);
    Marched result;
    Vec3 through = grey(1.0);
    for (int i = 0; i < steps; ++i) {
        const double a = static_cast<double>(i) / steps, b = (i + 1.0) / steps;
        const double t0 = exit.distance * a * a, t1 = exit.distance * b * b;
        const Vec3 p = from + (0.5 * (t0 + t1)) * direction;
        const Medium m = medium(p);
        const Vec3 sun = pi * sunlight(p);
        Vec3 scattered =
            product(all_orders ? phase(m, cosine) : (0.25 / pi) * m.scattering(), sun);
        if (all_orders) scattered = scattered + product(m.scattering(), further_light(p));
        // The integral is exact along a step of constant medium.
        const Vec3 passed = exp_of(-(t1 - t0) * m.extinction);
        const Vec3 gained = share(grey(1.0) - passed, m.extinction);
        result.light = result.light + product(through, product(scattered, gained));
        result.feeding =
            result.feeding + product(through, product(m.scattering(), gained));
        through = product(through, passed);
    }
    result.passed = through;
    if (exit.ground) {
        const Vec3 p = from + exit.distance * direction;
        const double facing = std::max(0.0, dot(normalized(p), sun_));
        result.light =
            result.light + product(through, ground_albedo_ * facing * sunlight(p));
    }
    return result;
}

Vec3 Atmosphere::multiple_scattering(double altitude) const {
    constexpr int kRings = 6, kSpokes = 10;
    const Vec3 from{0.0, 0.0, kGround + std::max(altitude, 1.0)};
    Vec3 second, feeding;
    for (int i = 0; i < kRings; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / kRings, r = std::sqrt(1.0 - z * z);
        for (int j = 0; j < kSpokes; ++j) {
            const double a = 2.0 * pi * (j + 0.5) / kSpokes;
            const Marched m =
                march(from, {r * std::cos(a), r * std::sin(a), z}, 16, false, kEndless);
            second = second + m.light;
            feeding = feeding + m.feeding;
        }
    }
    const double weight = 1.0 / (kRings * kSpokes);
    return share(weight * second, grey(1.0) - weight * feeding);
}

}  // namespace cydonia::render
