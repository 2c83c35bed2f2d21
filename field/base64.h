#pragma once

#include <string>
#include <string_view>

namespace cydonia {

// Bytes as text that attributes and URIs hold (RFC 4648, section 4).
std::string base64(std::string_view bytes);

}  // namespace cydonia
