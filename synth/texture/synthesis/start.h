#pragma once

#include "synth/texture/synthesis/layout.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// Where a synthesis starts from, unless types are asked for: see layout.h.
Layout start_of(const Database& database, const Controls& controls);

// The coarsest level before any correction: blocks of land from all over the exemplars.
// Where a block's piece is not of a type that a cell asks for, another that is; `types`
// may be empty.
Synthesis started(const Database& database, const Layout& layout,
                  const Field<TypeSet>& types, const Window& window);

// The layout's seams, once its level is reached: coarser ones know but blocks. Land of
// asked types stays as it is.
void cut_out(Synthesis& land, const Database& database, const Layout& layout,
             const Field<TypeSet>& types);

}  // namespace cydonia::texture
