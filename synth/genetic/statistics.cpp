#include "synth/genetic/statistics.h"

#include <cmath>

namespace cydonia::genetic {

Statistics statistics_of(std::span<const float> values) {
    Statistics s;
    s.count = values.size();
    const double n = double(values.size());
    if (values.empty()) return s;
    for (const float x : values) s.mean += x;
    s.mean /= n;
    double m2 = 0.0, m3 = 0.0, m4 = 0.0;  // eq. III.6
    for (const float x : values) {
        const double d = x - s.mean;
        m2 += d * d, m3 += d * d * d, m4 += d * d * d * d;
    }
    m2 /= n, m3 /= n, m4 /= n;
    s.deviation = std::sqrt(m2);
    // Values that are equal but for rounding have no shape.
    if (values.size() < 4 || !(s.deviation > 1e-9 * std::abs(s.mean) + 1e-30)) return s;
    // Eq. III.5.
    const double k2 = n / (n - 1.0) * m2;
    const double k3 = n * n / ((n - 1.0) * (n - 2.0)) * m3;
    const double k4 = n * n * ((n + 1.0) * m4 - 3.0 * (n - 1.0) * m2 * m2) /
                      ((n - 1.0) * (n - 2.0) * (n - 3.0));
    s.skewness = k3 / std::pow(k2, 1.5);
    s.kurtosis = k4 / (k2 * k2);
    return s;
}

}  // namespace cydonia::genetic
