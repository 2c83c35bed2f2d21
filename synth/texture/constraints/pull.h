#pragma once

#include "synth/texture/constraints/guidance.h"

namespace cydonia::texture {

// phi_d(x), eq. 8-9: how much of a height error x is corrected at distance d, all in
// metres. Small errors are left and large ones are reduced by lambda, where an error of s
// * d is large. On the constraint itself (d = 0) the limit, lambda * x, is used.
double phi(double x, double d, double s, double lambda);

// The height of a cell that would have h_c without constraints: h_c + phi_d(h_t - h_c).
// Beyond the paper, the correction fades over the outer half of its reach, so that the
// influence does not end in a cliff. It is h_c where nothing is asked.
float blended(float h_c, const Pull& pull, double s, double lambda);

}  // namespace cydonia::texture
