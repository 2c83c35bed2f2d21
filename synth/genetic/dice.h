#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "field/random.h"

namespace cydonia::genetic {

// A sequence of random numbers for one purpose. Equal seeds give equal sequences.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    double unit() { return cydonia::unit(state_ = mix(state_)); }  // 0 <= x < 1
    double signed_unit() { return 2.0 * unit() - 1.0; }
    // A whole number, 0 <= i < n.
    template <class Count>
    Count below(Count n) {
        return std::min(Count(unit() * double(n)), Count(n - 1));
    }
    double normal() {  // Box and Muller 1958
        const double u = std::max(unit(), 1e-12), v = unit();
        return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
    }

  private:
    std::uint64_t state_;
};

}  // namespace cydonia::genetic
