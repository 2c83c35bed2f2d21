#include "synth/texture/synthesis.h"

namespace cydonia::texture {

Synthesis synthesised(const Database&, const Controls&, const Guidance&,
                      const Window& window, Recording*, Progress&) {
    return {window, {}, {}};
}

Field<float> heights_of(const Database&, const Synthesis&) { return {}; }

}  // namespace cydonia::texture
