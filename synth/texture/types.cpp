#include "synth/texture/types.h"

namespace cydonia::texture {

TypeMap::TypeMap(const Options&, const Ground&, int) {}
bool TypeMap::empty() const { return levels_.empty(); }
Field<TypeSet> TypeMap::sets(const Window& window) const {
    return {window.width, window.height, kAnyType};
}

Field<std::uint8_t> painted_types(const Options&, int, int width, int height) {
    return {width, height, 254};
}

std::vector<Field<std::uint8_t>> automatic_types(std::span<const Field<float>>, double,
                                                 int) {
    return {};
}

}  // namespace cydonia::texture
