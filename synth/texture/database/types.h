#pragma once

#include <memory>
#include <span>

#include "field/terrain.h"
#include "synth/texture/constraints/geometry.h"
#include "synth/texture/constraints/guidance.h"
#include "synth/texture/options.h"

namespace cydonia::texture {

// What types the cells of the terrain may have (section 5.2), for every level from
// kFinestGuided on; the finest two are free.
inline constexpr int kFinestGuided = 2;

class TypeMap {
  public:
    // Reads options.paint. Throws bad_request: a colour that no type has.
    TypeMap(const Options& options, const Ground& ground, int levels);

    bool empty() const;  // nothing painted
    // R^i of a window of level kFinestGuided or coarser; kAnyType outside the terrain.
    Field<TypeSet> sets(const Window& window) const;

  private:
    int finest_ = kFinestGuided;  // a coarser one where the terrain has very many cells
    std::vector<Field<TypeSet>> levels_;  // from there on
};

// Types of an exemplar's cells, its T^0: painted, all one, or kNoType. `index` is its
// place in options.exemplars.
Field<std::uint8_t> painted_types(const Options& options, int index, int width,
                                  int height);

// Types found from the land itself (Options::automatic_types): clusters by slope, relief
// and curvature, the calmest first; where there is much water that is the first. One
// field an exemplar.
std::vector<Field<std::uint8_t>> automatic_types(std::span<const Field<float>> heights,
                                                 double spacing, int types);

}  // namespace cydonia::texture
