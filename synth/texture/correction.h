#pragma once

#include "synth/texture/synthesis.h"

namespace cydonia::texture {

// The passes and their four subpasses each (section 4). A subpass looks two cells around
// the cell that it changes, so what is right by that many cells less is right after it.
inline constexpr int kPasses = 2;
inline constexpr int kCorrectionHalo = 2 * 4 * kPasses;

// On the finest two levels places are snapped to the centres of cells: real-valued ones
// smooth the finest detail away (notes.md, trial 1).
inline bool is_snapped(int level, const Controls& controls) {
    return level <= controls.finest + 1;
}

// One pass, eq. 3 to 7, over all of the window but its outermost two cells.
void correct(Synthesis& land, const Database& database, const Controls& controls,
             const Guidance& guidance, int pass);

}  // namespace cydonia::texture
