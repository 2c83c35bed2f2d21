#pragma once

#include <functional>
#include <vector>

#include "synth/texture/constraints/geometry.h"
#include "synth/texture/database/database.h"
#include "synth/texture/database/orientation.h"
#include "synth/texture/options.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// Cells of the finest level and whatever covers one of them at coarser ones, as W's zeros
// spread (section 5.3).
struct Region {
    struct Layer {
        Window window;
        Field<std::uint8_t> inside;
        bool holds(int x, int y) const {
            return window.contains(x, y) && inside(x - window.x, y - window.y) != 0;
        }
    };
    std::vector<Layer> layers;  // finest level first
    int finest = 0;

    const Layer& at(int level) const { return layers[std::size_t(level - finest)]; }
};
// Grown by what reading out looks at, so that heights inside are those of the places.
Region region_of(const Window& window, Field<std::uint8_t> inside, int levels);

// Regions that are put down and locked (section 5.3).
class Pasting {
  public:
    // `land`: all passes of a window without pastes, for those taken from the terrain.
    using Land = std::function<Recording(const Window&)>;
    // Throws bad_request for pastes that would leave nothing on the terrain.
    Pasting(const Options& options, const Database& database, const Ground& ground,
            int finest, const Land& land);

    bool empty() const { return patches_.empty(); }
    // Locks the cells that pastes cover, later ones over earlier.
    void lay_down(const Window& window, int pass, Kept& kept) const;

  private:
    struct Patch {
        Region region;     // where it is put
        int exemplar = 0;  // from 1; 0: the terrain
        int orientation = 0;
        Step shift;  // half cells: a cell's centre, turned, and this is where it is from
        std::int32_t raise = 0;
        Recording land;
    };
    Patch patch_of(const Paste& paste, const Ground& ground) const;
    // Whether there is such land; places of a pass as the last there is.
    bool source(const Patch& patch, const Window& window, int x, int y, int pass,
                Place& place, std::int32_t& offset) const;

    const Database& database_;
    int finest_;
    std::vector<Patch> patches_;
};

}  // namespace cydonia::texture
