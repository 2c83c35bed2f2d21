#pragma once

#include <cstdint>
#include <vector>

#include "field/terrain.h"
#include "synth/context.h"
#include "synth/pareidolia/constrained/bend.h"
#include "synth/pareidolia/constrained/demand.h"

namespace cydonia::pareidolia {

// Rounds on the finished grid: the shadows are cast, margins are widened where the cast
// is wrong, and the land is solved further, as long as that helps. What several suns
// cannot have together shows in cells that stay wrong. These are relaxed, and the rest is
// solved further.
class Rounds {
  public:
    Rounds(double spacing, const std::vector<Demand>& demands, const Context& context);

    // The heights of the round with the fewest wrong samples.
    Field<float> best_of(Bend& bend);
    // Whether the demand of a cell was dropped and is not fulfilled. Valid after
    // best_of().
    bool gave_way(std::size_t image, int x, int y) const;

  private:
    void tightened(Bend& bend);
    void cast(Field<float> heights);
    bool give_way();

    Terrain terrain_;
    const std::vector<Demand> asked_;
    std::vector<Demand> demands_;
    const Context& context_;
    std::vector<Field<std::uint8_t>> casts_;
    std::size_t wrong_ = 0, least_ = 0;  // samples
    Field<float> best_;
    std::vector<Field<std::uint8_t>> best_casts_;
};

}  // namespace cydonia::pareidolia
