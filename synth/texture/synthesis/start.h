#pragma once

#include "synth/texture/synthesis/layout.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// The layout from which a synthesis starts; see layout.h.
Layout start_of(const Database& database, const Controls& controls);

// The coarsest level before any correction: blocks of land from all over the exemplars.
// Where a block's piece is not of a type that a cell asks for, another piece is taken for
// that cell. `types` may be empty.
Synthesis started(const Database& database, const Layout& layout,
                  const Field<TypeSet>& types, const Window& window);

// Applies the layout's seams on the layout's level, as coarser levels have whole blocks
// only. Cells with a requested type stay as they are.
void cut_out(Synthesis& land, const Database& database, const Layout& layout,
             const Field<TypeSet>& types);

}  // namespace cydonia::texture
