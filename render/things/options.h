#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/enum_names.h"
#include "field/length.h"
#include "field/source.h"

namespace cydonia::render {

// Things of one kind strewn over the land (Saunders 2006, VII.4): how densely they stand
// where all conditions are right, and these conditions. Numbers that are not set are the
// kind's own (originals.h).
struct ThingOptions {
    enum class Kind { kConifer, kBroadleaf, kShrub, kGrass, kRock, kBoulder };
    Kind kind = Kind::kConifer;
    std::optional<double> density = {};               // things a hectare
    std::optional<std::array<double, 2>> size = {};   // least and greatest height, metres
    std::optional<std::array<double, 2>> slope = {};  // none steeper than the second;
                                                      // all may stand below the first
    // The heights of the ground between which they stand. Towards the upper one, a tree
    // line, they become rarer and smaller. Default: everywhere.
    std::optional<Length> from = {}, to = {};
    std::string mask = {};  // a mask of the terrain that scales the density
    std::optional<Source> map =
        {};                 // a picture over the land that scales it: white 1, black 0
    double clumping = 0.5;  // 0 evenly strewn, 1 in groups and clearings
    // Whether they also stand where the land's shadows show an image, which they blur.
    bool in_image = false;
};

// More would cost more memory than a frame is worth.
inline constexpr std::size_t kMostKinds = 32;

inline constexpr Name<ThingOptions::Kind> kThingKinds[] = {
    {"conifer", ThingOptions::Kind::kConifer},
    {"broadleaf", ThingOptions::Kind::kBroadleaf},
    {"shrub", ThingOptions::Kind::kShrub},
    {"grass", ThingOptions::Kind::kGrass},
    {"rock", ThingOptions::Kind::kRock},
    {"boulder", ThingOptions::Kind::kBoulder}};
static_assert(is_complete(kThingKinds, ThingOptions::Kind::kBoulder));

}  // namespace cydonia::render
