#pragma once

#include "field/field.h"

namespace cydonia::pareidolia {

inline constexpr int kStencilSide = 768;  // pixels along the longer side of the drawing

// Turns a photograph (luma, 0 to 1) into a drawing in two tones with clean outlines. The
// result is its lightness, which is below a half where there is ink. `darkness`, 0 to 1,
// sets how much ink there is; at 0.5 the photograph decides. The drawing's size does not
// depend on the photograph's.
Field<float> stencil(const Field<float>& photograph, double darkness);

}  // namespace cydonia::pareidolia
