#pragma once

#include "field/field.h"

namespace cydonia::pareidolia {

inline constexpr int kStencilSide = 768;  // pixels along the longer side of the drawing

// A photograph (luma, 0 to 1) as a drawing in two tones with clean outlines: how light it
// is, below a half where ink goes. `darkness`, 0 to 1, says how much of it that is; 0.5
// lets the photograph decide. The drawing's size does not depend on the photograph's.
Field<float> stencil(const Field<float>& photograph, double darkness);

}  // namespace cydonia::pareidolia
