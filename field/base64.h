#pragma once

#include <string>
#include <string_view>

namespace cydonia {

// Encodes bytes as text that attributes and URIs can hold (RFC 4648, section 4).
std::string base64(std::string_view bytes);

}  // namespace cydonia
