#pragma once

#include <cstdint>

#include "field/field.h"
#include "synth/pareidolia/constrained/demand.h"

namespace cydonia::pareidolia {

// The samples of a cast (rays x rays in a cell) that contradict the demand.
struct Wrong {
    std::size_t lit = 0, dark = 0;  // that should be dark, lit
    std::size_t all() const { return lit + dark; }
};
Wrong wrong_in(const Demand& demand, const Field<std::uint8_t>& cast);

// Widens the margins where the cast is wrong, in a cell and around it. The caster sees
// what lies between the rows of light.
void tighten(Demand& demand, const Field<std::uint8_t>& cast);

}  // namespace cydonia::pareidolia
