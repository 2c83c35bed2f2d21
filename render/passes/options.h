#pragma once

#include <iterator>
#include <vector>

namespace cydonia::render {

// What can be known of every pixel besides its colour; docs/passes.md.
enum class Pass {
    kDepth,     // metres along the view's axis
    kPosition,  // world metres: east, north, up
    kNormal,    // world: east, north, up
    kHeight,    // metres
    kSlope,     // degrees
    kMaterial,  // number in the look
    kType,      // of the ground, as texture stages have them: 1 for the first by name
    kThing,     // number of its kind in the scene
    kShadow,    // share of the sun that is hidden from there
    kSky,       // share of the sky that is seen from there
    kMotion,    // pixels to the right and down until the next frame, of a sequence
};
inline constexpr Pass kAllPasses[] = {Pass::kDepth,  Pass::kPosition, Pass::kNormal,
                                      Pass::kHeight, Pass::kSlope,    Pass::kMaterial,
                                      Pass::kType,   Pass::kThing,    Pass::kShadow,
                                      Pass::kSky,    Pass::kMotion};

struct PassOptions {
    std::vector<Pass> which{std::begin(kAllPasses), std::end(kAllPasses)};
    bool separate = false;  // a file each, besides the frame, not one of many parts
};

}  // namespace cydonia::render
