#pragma once

#include <memory>

#include "field/terrain.h"

namespace cydonia::render {

// Hard shadows by Embree on the very mesh that POV-Ray renders: the (N-1) spacings
// between cell centres, squares split NW-SE, heights as given (round them to 16 bits
// first: field/quantise.h).
class Caster {
  public:
    // Builds the accelerator once; `heights` in metres. Throws bad_request unless they
    // are 2x2 to 16384x16384 finite samples.
    Caster(const Field<float>& heights, double spacing);
    ~Caster();
    Caster(Caster&&) noexcept;
    Caster& operator=(Caster&&) noexcept;

    // rays x rays samples a cell, centred in their sub-cells: (rays * width) x (rays *
    // height), 1 in shadow, 0 lit. Samples in the outer half cells stand on the mesh's
    // edge. Throws bad_request unless the sun is above the horizon.
    Field<std::uint8_t> shadow(const Sun& sun, int rays) const;
    // The same where `where`, a value a cell, is not 0, and around; 0 elsewhere.
    Field<std::uint8_t> shadow(const Sun& sun, int rays,
                               const Field<std::uint8_t>& where) const;

  private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace cydonia::render
