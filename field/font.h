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

// The font of that full name, or of a family and a style, as `fc-list` prints them, no
// matter the case; else what stands for it (its name tells). Throws failure() when no
// font is installed at all.
Font installed_font(const std::string& asked);
bool is_named(const Font& font, std::string_view asked);

// Those of the characters that the font, or any that is installed, has no shape for; each
// once, in order.
std::vector<char32_t> without_shape(const Font& font,
                                    const std::vector<char32_t>& characters);
std::vector<char32_t> without_any_shape(const std::vector<char32_t>& characters);

}  // namespace cydonia
