#pragma once

#include "synth/texture/synthesis.h"

namespace cydonia::texture {

// The coarsest level before any correction: blocks of land from all over the exemplars
//, each piece of them once before any comes again (pieces.h).
// Where a block's piece is not of a type that a cell asks for, the next that is; `types`
// may be empty.
Synthesis started(const Database& database, const Controls& controls,
                  const Field<TypeSet>& types, const Window& window);

}  // namespace cydonia::texture
