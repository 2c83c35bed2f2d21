#pragma once

#include <algorithm>

#include "field/field.h"

namespace cydonia::texture {

// Means over windows, computed from a summed-area table.
class WindowSums {
  public:
    explicit WindowSums(const Field<float>& values)
        : sums_(values.width() + 1, values.height() + 1) {
        for (int y = 0; y < values.height(); ++y) {
            double row = 0.0;
            for (int x = 0; x < values.width(); ++x) {
                row += static_cast<double>(values(x, y));
                sums_(x + 1, y + 1) = sums_(x + 1, y) + row;
            }
        }
    }
    // The mean of the field's cells at most `radius` cells away, each way.
    double mean(int x, int y, int radius) const {
        const int left = std::max(x - radius, 0), top = std::max(y - radius, 0);
        const int right = std::min(x + radius + 1, sums_.width() - 1);
        const int bottom = std::min(y + radius + 1, sums_.height() - 1);
        return (sums_(right, bottom) - sums_(left, bottom) - sums_(right, top) +
                sums_(left, top)) /
               (double(right - left) * double(bottom - top));
    }

  private:
    Field<double> sums_;
};

}  // namespace cydonia::texture
