#pragma once

#include "field/terrain.h"
#include "synth/method.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// Makes land whose shadows show images, from the terrain so far as the base. The solver
// "features" is Rusnell 2009, chapter 5: Algorithm 4 with the height bounds of Algorithms
// 5 to 7, for one image, with crests (section 5.3.1) or iterated holes (sections 5.3.2
// and 5.4). The solver "constrained" is our own (constrained/constrained.h): it bends the
// base as little as up to four images allow, each under a sun of its own. Both take
// targets from pictures, photographs drawn in two tones (stencil.h) and lines of text
// (lettering.h). Appends one ShadowImage per image to the result. Every cell may depend
// on the whole terrain. Throws bad_request for targets without shadow and for suns that
// cannot cast one.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 3;  // raised when the same options give other heights

Method method_of(const Options& options);
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads);

}  // namespace cydonia::pareidolia
