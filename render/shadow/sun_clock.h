#pragma once

#include <array>

#include "field/image.h"
#include "field/terrain.h"
#include "render/shadow/figures.h"

namespace cydonia::render {

inline constexpr int kClockSuns = 12;

// Twelve suns of one day, an hour apart, one of which is the image's own. The day is
// constructed: the sun moves from the eastern to the western horizon on the great circle
// through the image's sun that is highest in the south, or in the north if that sun is
// there (at least 30 degrees from its rise and its set).
struct ClockSuns {
    std::array<Sun, kClockSuns> suns;
    int own = 0;  // the index of the image's own sun
};
ClockSuns clock_suns(const Sun& own);

// A picture of the land under these suns with its shadows, four by three: the image
// appears and disappears. Each tile has its own exposure and is labelled with its sun;
// that of the image's own sun is framed.
Field<Rgb8> sun_clock(const CheckedLand& land, const Sun& own);

}  // namespace cydonia::render
