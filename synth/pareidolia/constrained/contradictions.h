#pragma once

#include <cstddef>
#include <vector>

#include "field/terrain.h"

namespace cydonia::pareidolia {

// Several suns may ask what no land can do. Where the shadow that `b` lies in is cast by
// `a`, and under another sun that which `d` lies in by `b`, while c = a + d - b is lit
// for the second sun and `d` for the first, the four inequalities add up to 0 > 0,
// whatever the heights.
struct Contradictions {
    std::size_t quadruples = 0;  // found
    // No land can do with fewer wrong cells: quadruples of which no two share one.
    std::size_t least_wrong = 0;
    std::size_t relaxed = 0;  // cells, of all images, that hit every quadruple
    // The mean over the images of the best IoU that any land can have.
    double bound = 1.0;
};

// Finds them and lets cells give way (ShadowImage::relaxed) until none is left. The cell
// that settles most goes first.
Contradictions settle(std::vector<ShadowImage>& images);

}  // namespace cydonia::pareidolia
