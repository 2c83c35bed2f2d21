#include "config/reader/elevation_models.h"
#include "config/reader/readers.h"

namespace cydonia::config {

void read(Table& t, dem::Options& o) {
    t.required("source", o.source, ElevationModel{});
    t.field("position", o.position, Number{from(0.0, 1.0)});
    t.field("fit", o.fit, Flag{});
    t.field("vertical_scale", o.vertical_scale, Number{above_to(0.0, 1000.0)});
}

}  // namespace cydonia::config
