#pragma once

#include <string>
#include <string_view>

namespace cydonia {

// Escapes text for XML and HTML, in elements and in quoted attributes.
std::string escaped(std::string_view text);

}  // namespace cydonia
