#pragma once

#include <optional>
#include <string>

#include "config/reader/mistakes.h"
#include "config/reader/value.h"

namespace cydonia::config {

// Sets one value of the document, as after --set: "terrain.stage[0].grain=5.5 %". The
// value is TOML; what is not ("features") is text. Tables on the way are made; entries of
// arrays must exist, counted from 0, as stage[0] or stage.0. Returns what is wrong.
std::optional<Mistake> apply_override(Value& document, const std::string& override_text,
                                      int origin);

}  // namespace cydonia::config
