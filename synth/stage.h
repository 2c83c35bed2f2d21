#pragma once

#include <span>
#include <variant>

#include "synth/dem/dem.h"
#include "synth/detail/detail.h"
#include "synth/distance/distance.h"
#include "synth/genetic/genetic.h"
#include "synth/method.h"
#include "synth/pareidolia/pareidolia.h"
#include "synth/sketch/sketch.h"
#include "synth/texture/texture.h"

namespace cydonia {

// The list of methods, an alternative each. What a method must have is in
// synth/method.h.
using StageOptions =
    std::variant<distance::Options, pareidolia::Options, dem::Options, texture::Options,
                 detail::Options, sketch::Options, genetic::Options>;

// Stages of a land, in order, the first of them first.
using Stages = std::span<const StageOptions* const>;

}  // namespace cydonia
