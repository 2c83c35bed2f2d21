#pragma once

#include <string>
#include <string_view>

namespace cydonia {

// Text as XML and HTML take it, in elements and in quoted attributes.
std::string escaped(std::string_view text);

}  // namespace cydonia
