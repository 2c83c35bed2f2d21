#pragma once

#include "synth/texture/synthesis.h"

namespace cydonia::texture {

// The coarsest level before any correction: blocks of land from all over the exemplars
// (notes.md, trial 4), each exemplar's places once before any comes again.
Synthesis started(const Database& database, const Controls& controls,
                  const Window& window);

}  // namespace cydonia::texture
