#include "synth/pareidolia/constrained/window.h"

#include <algorithm>

#include "field/cells_inside.h"

namespace cydonia::pareidolia {
namespace {

// As shares of the terrain's longer side: how far the window extends beyond the image,
// and the width of gaps that belong to it.
constexpr double kReach = 0.08, kGap = 0.16;

}  // namespace

Field<std::uint8_t> window_of(const Field<std::uint8_t>& target,
                              const Field<float>& noise) {
    const double side = std::max(target.width(), target.height());
    const double reach = kReach * side, gap = kGap * side;
    const Field<float> away = cells_inside(target, false);
    Field<std::uint8_t> near(target.width(), target.height());
    for (std::size_t i = 0; i < near.size(); ++i) near[i] = away[i] < gap;
    const Field<float> inside = cells_inside(near, true);
    Field<std::uint8_t> window(target.width(), target.height());
    for (std::size_t i = 0; i < window.size(); ++i) {
        const double within = inside[i] - (gap - reach);
        window[i] = target[i] || within > reach * (noise[i] - 0.5);
    }
    return window;
}

}  // namespace cydonia::pareidolia
