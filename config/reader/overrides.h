#pragma once

#include <optional>
#include <string>

#include "config/reader/mistakes.h"
#include "config/reader/value.h"

namespace cydonia::config {

// Sets one value of the document, given as after --set: "terrain.stage[0].grain=5.5 %".
// The value is TOML, and text when it is no TOML, such as features without quotes.
// Missing tables are made. Entries of arrays, as stage[0] or stage.0, are counted from 0
// and must exist. Returns what is wrong.
std::optional<Mistake> apply_override(Value& document, const std::string& override_text,
                                      int origin);

}  // namespace cydonia::config
