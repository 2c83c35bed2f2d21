#pragma once

#include <string_view>
#include <vector>

#include "field/enum_names.h"

namespace cydonia::render {

// What is known of every pixel besides its colour (docs/passes.md). A pass is a value, a
// row of the table below and its layer in passes.cpp.
enum class Pass {
    kDepth,     // metres along the view's axis
    kPosition,  // world metres: east, north, up
    kNormal,    // world: east, north, up
    kHeight,    // metres
    kSlope,     // degrees
    kMaterial,  // index into the look's materials
    kType,      // type of the land: 1 for the first by name, 0 for none
    kThing,     // number of its kind in the scene
    kShadow,    // share of the sun that is occluded
    kSky,       // share of the sky that is visible
    kMotion,    // pixels to the right and down until the next frame of a sequence
};
inline constexpr Name<Pass> kPasses[] = {
    {"depth", Pass::kDepth},   {"position", Pass::kPosition},
    {"normal", Pass::kNormal}, {"height", Pass::kHeight},
    {"slope", Pass::kSlope},   {"material", Pass::kMaterial},
    {"type", Pass::kType},     {"thing", Pass::kThing},
    {"shadow", Pass::kShadow}, {"sky", Pass::kSky},
    {"motion", Pass::kMotion}};
static_assert(is_complete(kPasses, Pass::kMotion));
constexpr std::string_view name_of(Pass pass) { return name_in(kPasses, pass); }

struct PassOptions {
    std::vector<Pass> which = values_in(kPasses);
    bool separate = false;  // one file for each pass instead of one EXR with all parts
};

}  // namespace cydonia::render
