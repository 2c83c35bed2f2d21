#include "synth/distance/distance.h"
#include "field/error.h"
namespace cydonia::distance {
Terrain run(const Options&, const Terrain&, const Context&) {
    throw failure("not built yet");
}
}  // namespace cydonia::distance
