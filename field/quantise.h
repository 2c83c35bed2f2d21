#pragma once

#include <cstdint>

#include "field/terrain.h"

namespace cydonia {

// Heights as POV-Ray stores them: 16-bit levels over [base, base + range] metres. The
// caster, the frames and the passes all use these, so that what is checked is what is
// rendered.
struct Heights16 {
    Field<std::uint16_t> levels;
    double base = 0.0;
    double range = 1.0;  // > 0 also where the land is flat
};

Heights16 quantised(const Field<float>& heights);
// The heights those levels stand for.
Field<float> heights_of(const Heights16& levels);

}  // namespace cydonia
