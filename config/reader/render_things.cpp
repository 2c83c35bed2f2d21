#include "config/reader/readers.h"

namespace cydonia::config {

using render::ThingOptions;

void read(Table& t, ThingOptions& thing) {
    t.required("kind", thing.kind, one_of(render::kThingKinds));
    t.field("density", thing.density, Number{from(0.0, 1e6)});
    t.field("size", thing.size, Number{from(0.01, 200.0)});
    t.field("slope", thing.slope, Degrees{between(0.0, 90.0)});
    t.field("from", thing.from, LengthUnit{});
    t.field("to", thing.to, LengthUnit{});
    t.field("mask", thing.mask, Text{});
    t.field("map", thing.map, File{});
    t.field("clumping", thing.clumping, Number{from(0.0, 1.0)});
    t.field("in_image", thing.in_image, Flag{});
    t.check(!thing.size || (*thing.size)[0] <= (*thing.size)[1], {"size"},
            "the least size is greater than the most: write them as [least, most]");
    t.check(
        !thing.slope || (*thing.slope)[0] < (*thing.slope)[1], {"slope"},
        "the slope where things become fewer must be below the slope where none stands");
}

}  // namespace cydonia::config
