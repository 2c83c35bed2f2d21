#pragma once

namespace cydonia::render {

// How a preview shows the land. The last three are those of J. Brosz, "Terrain Modeling
// by Example" (2007), section 6.
enum class Style {
    kNatural,  // as the frame will be: ground, sun, sky, haze, water
    kGrey,     // grey, lit by the sun without shadows
    kHeight,   // coloured by height: brown, green, red, orange, yellow, white
    kSlope,    // coloured by slope, from the steepest: yellow, red, green, grey
};

}  // namespace cydonia::render
