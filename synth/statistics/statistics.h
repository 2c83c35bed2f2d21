#pragma once

#include <cstddef>
#include <span>

namespace cydonia::statistics {

// Statistics that tell distributions apart (Saunders 2006, section III.3.3).
struct Statistics {
    std::size_t count = 0;
    double mean = 0.0;
    double deviation = 0.0;  // sample standard deviation (eq. III.3)
    double skewness = 0.0;   // by k-statistics (eq. III.4)
    double kurtosis = 0.0;   // excess (eq. III.7)
};

// For fewer than four values, or for equal ones, some of the statistics are 0.
Statistics statistics_of(std::span<const float> values);

// Accumulates the same statistics. Moments can be added, so that those of a window are
// the sum of those of its blocks. `about` is a number near the mean, the same for all
// values and all parts.
class Moments {
  public:
    void add(double value, double about) {
        const double d = value - about, dd = d * d;
        n_ += 1.0, s1_ += d, s2_ += dd, s3_ += dd * d, s4_ += dd * dd;
    }
    Moments& operator+=(const Moments& other);
    Statistics statistics(double about) const;

  private:
    double n_ = 0.0, s1_ = 0.0, s2_ = 0.0, s3_ = 0.0, s4_ = 0.0;
};

}  // namespace cydonia::statistics
