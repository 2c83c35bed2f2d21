#pragma once

#include <nlohmann/json.hpp>

namespace cydonia {

// Objects keep the order in which their keys were set, as a reader of the file expects.
using Json = nlohmann::ordered_json;

}  // namespace cydonia
