#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"

namespace cydonia::pareidolia {

// The homotopic tree of a shadow image (Rusnell 2009, section 5.3.2, figure 5.9): its
// connected regions, each below the one that surrounds it. Shadow and light alternate
// from depth to depth, so that shadow has odd depths.
struct RegionTree {
    static constexpr int kBackground = 0;  // the root, light; goes on beyond the frame

    struct Node {
        int parent = -1;  // -1: none, the background
        int depth = 0;
    };
    std::vector<Node> regions;  // each after its parent
    Field<int> region_at;       // of each cell

    int depth_at(std::size_t cell) const { return regions[region_at[cell]].depth; }
};

// Shadow (1) is connected across corners as well, light (0) across sides only, so that no
// two regions cross and the regions form a tree. A region that touches the frame is
// surrounded by the background there, and light that touches the frame is background.
RegionTree region_tree(const Field<std::uint8_t>& image);

}  // namespace cydonia::pareidolia
