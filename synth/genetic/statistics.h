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

}  // namespace cydonia::genetic
