#include "render/shadow/outline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "field/cells_inside.h"
#include "field/error.h"
#include "render/shadow/shading.h"

namespace cydonia::render {

namespace {

constexpr double kNear = 2.0;  // cells

// A sum and the number of its terms.
struct Sum {
    double total = 0.0;
    std::size_t count = 0;
    void add(double value) {
        total += value;
        ++count;
    }
    double mean() const { return total / static_cast<double>(count); }
};

}  // namespace

Field<std::uint8_t> near_outline(const Field<std::uint8_t>& target) {
    Field<std::uint8_t> near(target.width(), target.height());
    const auto dark = std::ranges::count_if(target, [](auto t) { return t != 0; });
    if (dark == 0 || dark == static_cast<std::ptrdiff_t>(target.size())) return near;
    // Distances to the nearest cell of the other value, whose middle is half a cell
    // beyond the outline. One of the two is 0.
    const Field<float> dark_side = cells_inside(target, true);
    const Field<float> light_side = cells_inside(target, false);
    for (std::size_t i = 0; i < near.size(); ++i)
        near[i] = dark_side[i] + light_side[i] <= kNear + 0.5;
    return near;
}

double outline_shading(const Field<float>& heights, double spacing, const Sun& sun,
                       const Field<std::uint8_t>& near) {
    if (!near.same_shape(heights) || std::min(near.width(), near.height()) < 3)
        throw bad_request("an outline of {}x{} cells does not fit {}x{} heights",
                          near.width(), near.height(), heights.width(), heights.height());
    const Field<float> light = shading(heights, spacing, sun);
    std::array<Sum, 2> sums;  // elsewhere, near
    for (int y = 1; y + 1 < light.height(); ++y)
        for (int x = 1; x + 1 < light.width(); ++x)
            sums[near(x, y) != 0].add(0.5 *
                                      std::hypot(light(x + 1, y) - light(x - 1, y),
                                                 light(x, y + 1) - light(x, y - 1)));
    const auto [elsewhere, close] = sums;
    if (close.count == 0 || !(elsewhere.total > 0.0)) return 1.0;
    return close.mean() / elsewhere.mean();
}

}  // namespace cydonia::render
