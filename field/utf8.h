#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace cydonia {

// The characters of a UTF-8 text; none when it is not well formed (Unicode 15, table
// 3-7: no overlong forms, no surrogates, nothing above U+10FFFF).
std::optional<std::vector<char32_t>> characters_of(std::string_view text);

}  // namespace cydonia
