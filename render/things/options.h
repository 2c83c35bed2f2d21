#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/enum_names.h"
#include "field/length.h"
#include "field/source.h"

namespace cydonia::render {

// Things of one kind strewn over the land (Saunders 2006, VII.4): how many there are
// where all suits them, and what suits them. `unset` numbers are the kind's own.
struct ThingOptions {
    enum class Kind { kConifer, kBroadleaf, kShrub, kGrass, kRock, kBoulder };
    Kind kind = Kind::kConifer;
    std::optional<double> density = {};               // a hectare
    std::optional<std::array<double, 2>> size = {};   // height from and to, metres
    std::optional<std::array<double, 2>> slope = {};  // none steeper than the second;
                                                      // all may stand below the first
    // Between these heights of the ground; towards the upper they thin out and stay
    // small: a tree line. Default: everywhere.
    std::optional<Length> from = {}, to = {};
    std::string mask = {};           // one of the terrain's: as many as it says
    std::optional<Source> map = {};  // a picture over the land: white many, black none
    double clumping = 0.5;           // 0 evenly strewn, 1 in groups and clearings
    // Also where the land's shadows show an image, which things would blur.
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
