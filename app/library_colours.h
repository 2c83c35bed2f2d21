#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>

namespace cydonia {

// "#0072b2"
inline std::string hex_of(const std::array<std::uint8_t, 3>& rgb) {
    return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

}  // namespace cydonia
