#pragma once

#include <vector>

#include "synth/texture/synthesis/origins.h"

namespace cydonia::texture {

// Two numbers that describe the land at each cell of a level: its height, and the
// logarithm of the mean step from cell to cell two levels finer. Both are in standard
// deviations over all exemplars. The database must outlive it.
class Character {
  public:
    Character(const Database& database, int level);

    int half() const { return 1 << level_; }  // half cells of level 0 in half a cell
    int exemplars() const { return static_cast<int>(of_.sheets.size()); }
    const Sheet& sheet(int exemplar) const {
        return of_.sheets[static_cast<std::size_t>(exemplar)];
    }
    // The index in the arrays of the cell that contains a position, or of the exemplar's
    // nearest cell.
    std::size_t index(Spot spot) const {
        const Sheet& s = sheet(spot.exemplar);
        spot = kept_inside(spot, s, level_);
        return s.index(spot.x >> (level_ + 1), spot.y >> (level_ + 1));
    }
    bool is_land(std::size_t at) const { return of_.types[at] != kNowhere; }
    float height(std::size_t at) const { return heights_[at]; }
    float roughness(std::size_t at) const { return roughnesses_[at]; }

  private:
    int level_;
    const Level& of_;
    std::vector<float> heights_, roughnesses_;
};

}  // namespace cydonia::texture
