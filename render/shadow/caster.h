#pragma once

#include <memory>

#include "field/terrain.h"

namespace cydonia::render {

// Casts hard shadows with Embree on the same mesh that POV-Ray renders: the (N-1)
// spacings between cell centres, squares split NW-SE. Heights are used as given, so round
// them to 16 bits first (field/quantise.h).
class Caster {
  public:
    // Builds the acceleration structure. `heights` are in metres. Throws bad_request
    // unless they are 2x2 to 16384x16384 finite samples.
    Caster(const Field<float>& heights, double spacing);
    ~Caster();
    Caster(Caster&&) noexcept;
    Caster& operator=(Caster&&) noexcept;

    // The shadow at rays x rays samples a cell, at the centres of sub-cells: a mask of
    // (rays * width) x (rays * height), 1 in shadow and 0 lit. Samples in the outer half
    // cells are taken at the mesh's edge. Throws bad_request unless the sun is above the
    // horizon.
    Field<std::uint8_t> shadow(const Sun& sun, int rays) const;
    // The same in and around the cells where `where` is not 0; other samples are 0.
    Field<std::uint8_t> shadow(const Sun& sun, int rays,
                               const Field<std::uint8_t>& where) const;

  private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace cydonia::render
