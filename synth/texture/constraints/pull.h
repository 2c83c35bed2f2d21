#pragma once

#include "synth/texture/constraints/guidance.h"

namespace cydonia::texture {

// phi_d(x), eq. 8-9: how much of a height error x is corrected at distance d, all in
// metres. Small errors are left, large ones are taken off by lambda; s * d is what counts
// as large. On the constraint itself (d = 0) that is lambda * x, the limit.
double phi(double x, double d, double s, double lambda);

// Height of a cell that would be h_c, under what is asked of it: h_c + phi_d(h_t - h_c),
// ours eased out over the outer half of its reach, so that influence does not end in a
// cliff. The nearer the constraint the more; h_c where the cell is free.
float blended(float h_c, const Pull& pull, double s, double lambda);

}  // namespace cydonia::texture
