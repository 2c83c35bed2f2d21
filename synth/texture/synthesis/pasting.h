#pragma once

#include <functional>
#include <vector>

#include "synth/texture/constraints/geometry.h"
#include "synth/texture/database/database.h"
#include "synth/texture/database/orientation.h"
#include "synth/texture/options.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// A set of cells of the finest level, and on coarser levels all cells that contain one of
// them, as the zeros of W spread (section 5.3).
struct CellSet {
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
// The set of a window's cells where `inside` is not 0, grown by the radius of the
// read-out, so that heights inside depend on the set only.
CellSet cell_set_of(const Window& window, Field<std::uint8_t> inside, int levels);

// The regions that pastes put down and lock (section 5.3).
class Pasting {
  public:
    // Makes all passes of a window of the land without pastes, for pastes that are taken
    // from the terrain.
    using Land = std::function<Recording(const Window&)>;
    // Throws bad_request for a paste that lies outside the terrain.
    Pasting(const Options& options, const Database& database,
            const geometry::Ground& ground, int finest, const Land& land);

    bool empty() const { return patches_.empty(); }
    // Locks the cells that pastes cover; later pastes lie over earlier ones.
    void lay_down(const Window& window, int pass, PinnedRegion& pinned) const;

  private:
    struct Patch {
        CellSet region;    // where it is put
        int exemplar = 0;  // from 1; 0: the terrain
        int orientation = 0;
        Step shift;  // half cells, added to a cell's turned centre
        std::int32_t raise = 0;
        Recording land;
    };
    Patch patch_of(const Paste& paste, const geometry::Ground& ground) const;
    // The land of a cell in a patch; false where it has none. For a pass beyond the last
    // one the last is used.
    bool source(const Patch& patch, const Window& window, int x, int y, int pass,
                Origin& place, std::int32_t& offset) const;

    const Database& database_;
    int finest_;
    std::vector<Patch> patches_;
};

}  // namespace cydonia::texture
