#include "synth/distance/map.h"

#include "field/strokes.h"

namespace cydonia::distance {

Field<float> map_values(const Map& map, int width, int height) {
    Field<float> values = read_grey_at(map.image, width, height);
    const auto black = static_cast<float>(map.range[0]);
    const auto white = static_cast<float>(map.range[1]);
    for (float& value : values) value = black + (white - black) * value;
    return values;
}

}  // namespace cydonia::distance
