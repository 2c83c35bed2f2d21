#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "config/reader/value.h"

namespace cydonia::config {

// The position where brackets or dotted keys of a TOML text nest deeper than 32 levels,
// if they do. toml++ bounds brackets only, at 256; its tables destroy each other
// recursively, so that a long enough [a.a.a.a...] would end in a stack overflow.
std::optional<Position> too_deep(std::string_view text);

}  // namespace cydonia::config
