#include "field/utf8.h"

#include <cstddef>

namespace cydonia {
namespace {

// Bytes of the character that a byte begins; 0 where none can.
int length_from(unsigned char first) {
    if (first < 0x80) return 1;
    if (first >= 0xc2 && first < 0xe0) return 2;
    if (first >= 0xe0 && first < 0xf0) return 3;
    if (first >= 0xf0 && first < 0xf5) return 4;
    return 0;
}

bool is_scalar(char32_t c, int length) {
    if (length == 3) return c >= 0x800 && (c < 0xd800 || c > 0xdfff);
    if (length == 4) return c >= 0x10000 && c <= 0x10ffff;
    return true;
}

}  // namespace

std::optional<std::vector<char32_t>> characters_of(std::string_view text) {
    std::vector<char32_t> characters;
    while (!text.empty()) {
        const auto first = static_cast<unsigned char>(text[0]);
        const int length = length_from(first);
        if (length == 0 || text.size() < std::size_t(length)) return std::nullopt;
        char32_t c = length == 1 ? first : first & (0x7fu >> length);
        for (int i = 1; i < length; ++i) {
            const auto byte = static_cast<unsigned char>(text[std::size_t(i)]);
            if ((byte & 0xc0u) != 0x80u) return std::nullopt;
            c = c << 6 | (byte & 0x3fu);
        }
        if (!is_scalar(c, length)) return std::nullopt;
        characters.push_back(c);
        text.remove_prefix(std::size_t(length));
    }
    return characters;
}

}  // namespace cydonia
