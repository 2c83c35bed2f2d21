#pragma once

#include <string_view>

#include "config/reader/value.h"

namespace cydonia::config {

// The tree of a TOML document, whose positions all have this origin. Throws
// bad_request("<name>:line:column: ...") at the first syntax error, and where tables,
// arrays and dotted keys nest deeper than a scene ever does.
Value parse(std::string_view text, std::string_view name, int origin = 0);

}  // namespace cydonia::config
