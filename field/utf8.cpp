#include "field/utf8.h"

#include <glib.h>

namespace cydonia {

std::optional<std::vector<char32_t>> characters_of(std::string_view text) {
    std::vector<char32_t> characters;
    const char* const end = text.data() + text.size();
    for (const char* at = text.data(); at != end; at = g_utf8_next_char(at)) {
        // For GLib a zero byte would be the end of the text.
        const gunichar c = *at == '\0' ? 0 : g_utf8_get_char_validated(at, end - at);
        if (c > 0x10ffff) return std::nullopt;  // its two marks of what is invalid
        characters.push_back(c);
    }
    return characters;
}

}  // namespace cydonia
