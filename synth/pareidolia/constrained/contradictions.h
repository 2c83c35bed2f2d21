#pragma once

#include <cstddef>
#include <vector>

#include "field/terrain.h"

namespace cydonia::pareidolia {

// Several suns may require what no land can show. Suppose that `a` casts the shadow in
// which `b` lies, and under another sun `b` casts the shadow in which `d` lies, while c =
// a + d - b is lit for the second sun and `d` for the first. Then the four inequalities
// add up to 0 > 0 for all heights.
struct Contradictions {
    std::size_t quadruples = 0;  // found
    // A lower bound of the wrong cells in any land: the number of quadruples no two of
    // which share a cell.
    std::size_t least_wrong = 0;
    std::size_t relaxed = 0;  // cells, of all images, that hit every quadruple
    // The mean over the images of the best IoU that any land can have.
    double bound = 1.0;
};

// Finds the contradictions and relaxes cells (ShadowImage::relaxed) until none is left.
// The cell that resolves most of them is relaxed first.
Contradictions settle(std::vector<ShadowImage>& images);

}  // namespace cydonia::pareidolia
