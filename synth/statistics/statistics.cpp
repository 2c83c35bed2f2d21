#include "synth/statistics/statistics.h"

#include <algorithm>
#include <cmath>

namespace cydonia::statistics {

namespace {

// Statistics from central moments (eq. III.6).
Statistics of_moments(double n, double mean, double m2, double m3, double m4) {
    Statistics s{std::size_t(n), mean, std::sqrt(m2)};
    // Values that are equal but for rounding have no skewness and no kurtosis.
    if (n < 4.0 || !(s.deviation > 1e-9 * std::abs(s.mean) + 1e-30)) return s;
    // The k-statistics, eq. III.5.
    const double k2 = n / (n - 1.0) * m2;
    const double k3 = n * n / ((n - 1.0) * (n - 2.0)) * m3;
    const double k4 = n * n * ((n + 1.0) * m4 - 3.0 * (n - 1.0) * m2 * m2) /
                      ((n - 1.0) * (n - 2.0) * (n - 3.0));
    s.skewness = k3 / std::pow(k2, 1.5);
    s.kurtosis = k4 / (k2 * k2);
    return s;
}

}  // namespace

Statistics statistics_of(std::span<const float> values) {
    if (values.empty()) return {};
    const double n = double(values.size());
    double mean = 0.0, m2 = 0.0, m3 = 0.0, m4 = 0.0;
    for (const float x : values) mean += x;
    mean /= n;
    for (const float x : values) {
        const double d = x - mean, dd = d * d;
        m2 += dd, m3 += dd * d, m4 += dd * dd;
    }
    return of_moments(n, mean, m2 / n, m3 / n, m4 / n);
}

Moments& Moments::operator+=(const Moments& other) {
    n_ += other.n_, s1_ += other.s1_, s2_ += other.s2_;
    s3_ += other.s3_, s4_ += other.s4_;
    return *this;
}

Statistics Moments::statistics(double about) const {
    if (!(n_ > 0.0)) return {};
    // Central moments from those about a number.
    const double d = s1_ / n_, p2 = s2_ / n_, p3 = s3_ / n_, p4 = s4_ / n_;
    const double m2 = std::max(0.0, p2 - d * d), m3 = p3 - 3.0 * d * p2 + 2.0 * d * d * d,
                 m4 = p4 - 4.0 * d * p3 + 6.0 * d * d * p2 - 3.0 * d * d * d * d;
    return of_moments(n_, about + d, m2, m3, m4);
}

}  // namespace cydonia::statistics
