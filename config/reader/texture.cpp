#include "config/reader/readers.h"

namespace cydonia::config {

void read(Table& t, texture::Options& o) {
    t.field("jitter", o.jitter, Number{from(0.0, 4.0)});
}

}  // namespace cydonia::config
