#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace cydonia {

using Point2 = std::array<double, 2>;

// Appends points of the cubic Bezier curve from p[0] (left out) to p[3], so many that
// straight lines between them stay within `tolerance` of it (Wang's bound).
inline void flatten(const std::array<Point2, 4>& p, double tolerance,
                    std::vector<Point2>& out) {
    double bend = 0.0;
    for (int i = 0; i < 2; ++i)
        bend = std::max(bend, std::hypot(p[i][0] - 2.0 * p[i + 1][0] + p[i + 2][0],
                                         p[i][1] - 2.0 * p[i + 1][1] + p[i + 2][1]));
    const double wanted = std::ceil(std::sqrt(0.75 * bend / tolerance));
    const int count = static_cast<int>(std::clamp(wanted, 1.0, 1024.0));
    for (int k = 1; k <= count; ++k) {
        const double t = double(k) / count, s = 1.0 - t;
        const double w[] = {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
        Point2 point{};
        for (int i = 0; i < 4; ++i)
            for (int axis = 0; axis < 2; ++axis) point[axis] += w[i] * p[i][axis];
        out.push_back(point);
    }
}

}  // namespace cydonia
