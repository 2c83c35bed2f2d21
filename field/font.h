#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cydonia {

// An installed font, in the words of CSS.
struct Font {
    std::string name;    // "DejaVu Sans Bold"
    std::string family;  // "DejaVu Sans"
    std::string style;   // "normal", "italic" or "oblique"
    int weight = 400;    // 100 to 900
    int stretch = 100;   // percent
    std::string file;
};

// The installed font with this full name, or with this family and style, as `fc-list`
// prints them; upper and lower case are the same. Otherwise the font that fontconfig puts
// in its place, which is_named() tells. Throws failure() when no font is installed.
Font installed_font(const std::string& asked);
bool is_named(const Font& font, std::string_view asked);

// The characters for which the font, or every installed font, has no shape: each once, in
// order.
std::vector<char32_t> without_shape(const Font& font,
                                    const std::vector<char32_t>& characters);
std::vector<char32_t> without_any_shape(const std::vector<char32_t>& characters);

}  // namespace cydonia
