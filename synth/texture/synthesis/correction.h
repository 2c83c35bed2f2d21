#pragma once

#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// The number of passes; each has four subpasses (section 4). A subpass looks at two cells
// around the one that it changes, so it narrows the exact part of a window by two cells
// on each side.
inline constexpr int kPasses = 2;
inline constexpr int kCorrectionHalo = 2 * 4 * kPasses;

// On the two finest levels positions are snapped to the centres of cells, because
// real-valued ones smooth the finest detail away (docs/papers.md, Gain 2015, trial 1).
inline bool is_snapped(int level, const Controls& controls) {
    return level <= controls.finest + 1;
}

// What points, curves and types ask of the cells of a window; empty fields ask for
// nothing. On the two finest levels nothing is asked any more, but types that coarser
// levels sorted stay sorted.
struct CellGuidance {
    Field<Pull> pulls = {};
    Field<TypeSet> types = {};
    bool typed = false;  // types are requested on this level or a coarser one
};

// One pass, eq. 3 to 9, over the window without its two outermost cells.
void correct(Synthesis& land, const Database& database, const Controls& controls,
             const CellGuidance& guidance, const PinnedRegion& pinned, int pass);

// Smoothly removes the errors at points and curves that the passes of a level have left
// (docs/papers.md, Gain 2015, trial 10). It looks at kLiftHalo cells around each cell.
inline constexpr int kLiftHalo = 12;
void lift(Synthesis& land, const Database& database, const CellGuidance& guidance,
          const PinnedRegion& pinned);

}  // namespace cydonia::texture
