#pragma once

#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// The passes and their four subpasses each (section 4). A subpass looks two cells around
// the cell that it changes, so what is right by that many cells less is right after it.
inline constexpr int kPasses = 2;
inline constexpr int kCorrectionHalo = 2 * 4 * kPasses;

// On the finest two levels places are snapped to the centres of cells: real-valued ones
// smooth the finest detail away (docs/papers.md, trial 1).
inline bool is_snapped(int level, const Controls& controls) {
    return level <= controls.finest + 1;
}

// What points, curves and types ask of the cells of a window; empty: nothing. On the
// finest two levels they ask nothing more, but types that coarser levels sorted stay
// sorted.
struct Asked {
    Field<Pull> pulls = {};
    Field<TypeSet> types = {};
    bool typed = false;  // types are asked for, on this level or coarser ones
};

// One pass, eq. 3 to 9, over all of the window but its outermost two cells.
void correct(Synthesis& land, const Database& database, const Controls& controls,
             const Asked& asked, const Kept& kept, int pass);

// What the passes of a level have left of the errors at points and curves, taken off
// smoothly (docs/papers.md, trial 10). Looks kLiftHalo cells around.
inline constexpr int kLiftHalo = 12;
void lift(Synthesis& land, const Database& database, const Asked& asked,
          const Kept& kept);

}  // namespace cydonia::texture
