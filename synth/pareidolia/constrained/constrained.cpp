#include "synth/pareidolia/constrained/constrained.h"

namespace cydonia::pareidolia {

Field<float> constrained(const Options&, const Terrain& base, std::vector<ShadowImage>&,
                         const Context&) {
    return base.heights;
}

}  // namespace cydonia::pareidolia
