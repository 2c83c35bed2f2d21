#include "synth/texture/constraints/pull.h"

#include <cmath>

namespace cydonia::texture {
namespace {

// 1 up to half of the reach, then falling to 0, with no slope at either end.
double eased(double share) {
    if (share <= 0.5) return 1.0;
    if (share >= 1.0) return 0.0;
    const double u = 2.0 * (1.0 - share);
    return u * u * (3.0 - 2.0 * u);
}

}  // namespace

double phi(double x, double d, double s, double lambda) {
    const double t = s * d;
    if (std::abs(x) > t) return lambda * (x - std::copysign(2.0 / 3.0 * t, x));
    return t > 0.0 ? lambda / 3.0 * x * (x / t) * (x / t) : 0.0;
}

float blended(float h_c, const Pull& pull, double s, double lambda) {
    if (!(pull.reach > 0.0f)) return h_c;
    const double share = double(pull.distance) / double(pull.reach);
    const double error = double(pull.target) - double(h_c);
    return static_cast<float>(h_c + eased(share) * phi(error, pull.distance, s, lambda));
}

}  // namespace cydonia::texture
