#include "synth/pareidolia/pareidolia.h"
#include "field/error.h"
namespace cydonia::pareidolia {
Terrain run(const Options&, const Terrain&, const Context&) {
    throw failure("not built yet");
}
}  // namespace cydonia::pareidolia
