#pragma once

#include <cstdint>

#include "field/field.h"
#include "synth/pareidolia/constrained/demand.h"

namespace cydonia::pareidolia {

// Samples of a cast (rays x rays a cell) that are not what the demand asks for.
struct Wrong {
    std::size_t lit = 0, dark = 0;  // that should be dark, lit
    std::size_t all() const { return lit + dark; }
};
Wrong wrong_in(const Demand& demand, const Field<std::uint8_t>& cast);

// Wider margins where the cast is wrong, in a cell and around it: what the rows of light
// do not see between them, the caster does.
void tighten(Demand& demand, const Field<std::uint8_t>& cast);

}  // namespace cydonia::pareidolia
