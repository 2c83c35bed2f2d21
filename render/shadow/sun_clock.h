#pragma once

#include <array>

#include "field/image.h"
#include "field/terrain.h"
#include "render/shadow/figures.h"

namespace cydonia::render {

inline constexpr int kClockSuns = 12;

// Twelve suns of one day, an hour apart; one is the image's own. A day of its own
// making: from the eastern horizon to the western along the great circle through the
// image's sun that is highest in the south, or in the north where that sun stands there
// (at least 30 degrees from its rise and its set).
struct ClockSuns {
    std::array<Sun, kClockSuns> suns;
    int own = 0;  // which of them is the image's
};
ClockSuns clock_suns(const Sun& own);

// The land as those suns light it, shadows and all, four by three: the image appears and
// goes. Each is exposed for itself and says where its sun stands; the image's own is
// framed.
Field<Rgb8> sun_clock(const CheckedLand& land, const Sun& own);

}  // namespace cydonia::render
