#pragma once

#include <cstdint>
#include <vector>

#include "field/terrain.h"
#include "synth/context.h"
#include "synth/pareidolia/constrained/bend.h"
#include "synth/pareidolia/constrained/demand.h"

namespace cydonia::pareidolia {

// The finished grid, cast again and again: margins are widened where the cast is wrong
// and the land is solved on, while it helps. What several suns cannot have together shows
// in cells that stay wrong: they give way, and the rest is solved on.
class Rounds {
  public:
    Rounds(double spacing, const std::vector<Demand>& demands, const Context& context);

    // Of all rounds the heights with the fewest wrong samples.
    Field<float> best_of(Bend& bend);
    // Whether what was asked of a cell is asked no more, and not there. After best_of.
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
