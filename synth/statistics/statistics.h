#pragma once

#include <cstddef>
#include <span>

namespace cydonia::genetic {

// What tells distributions apart (Saunders 2006, section III.3.3).
struct Statistics {
    std::size_t count = 0;
    double mean = 0.0;
    double deviation = 0.0;  // sample standard deviation (eq. III.3)
    double skewness = 0.0;   // by k-statistics (eq. III.4)
    double kurtosis = 0.0;   // excess (eq. III.7)
};

// Of fewer than four values, or of equal ones, some are 0.
Statistics statistics_of(std::span<const float> values);

// The same of numbers that come one by one and are added up in parts: a window's are the
// sum of its blocks'. `about` a number near their mean, the same for all that are added.
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

}  // namespace cydonia::genetic
