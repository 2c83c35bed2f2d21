#include "synth/texture/texture.h"

namespace cydonia::texture {

Terrain run(const Options&, const Terrain& terrain, const Context&) { return terrain; }

}  // namespace cydonia::texture
