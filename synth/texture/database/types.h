#pragma once

#include <memory>
#include <span>

#include "field/terrain.h"
#include "synth/texture/constraints/geometry.h"
#include "synth/texture/constraints/guidance.h"
#include "synth/texture/options.h"

namespace cydonia::texture {

// The types that cells of the terrain may have (section 5.2), on every level from
// kFinestGuided on. On the two finest levels types are free.
inline constexpr int kFinestGuided = 2;

class TypeMap {
  public:
    // Reads options.paint. Throws bad_request for a colour that no type has.
    TypeMap(const Options& options, const geometry::Ground& ground, int levels);

    bool empty() const;  // nothing painted
    // R^i of a window of level kFinestGuided or coarser; kAnyType outside the terrain.
    Field<TypeSet> sets(const Window& window) const;

  private:
    int finest_ = kFinestGuided;  // a coarser one where the terrain has very many cells
    std::vector<Field<TypeSet>> levels_;  // from there on
};

// The types, T^0, of an exemplar's cells: painted, all the same, or kNoType. `index`
// counts options.exemplars.
Field<std::uint8_t> painted_types(const Options& options, int index, int width,
                                  int height);

// Types found from the land itself (Options::automatic_types): clusters by slope, relief
// and curvature, the calmest first. Where there is much water, it is the first. The
// result has a field for each exemplar.
std::vector<Field<std::uint8_t>> automatic_types(std::span<const Field<float>> heights,
                                                 double spacing, int types);

}  // namespace cydonia::texture
