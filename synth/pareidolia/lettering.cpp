#include "synth/pareidolia/lettering.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/font.h"
#include "field/markup.h"
#include "field/svg.h"
#include "field/utf8.h"

namespace cydonia::pareidolia {
namespace {

constexpr std::size_t kMostLetters = 256;
// The size of an em in units of the drawing. A drawing has at most as many pixels,
// because FreeType fails at magnified letters.
constexpr double kEm = 4000.0;

std::vector<char32_t> letters_of(const std::string& text) {
    const auto letters = characters_of(text);
    if (!letters) throw bad_request("text: it is not UTF-8");
    if (letters->size() > kMostLetters)
        throw bad_request("text: {} letters are too many; at most {}", letters->size(),
                          kMostLetters);
    for (const char32_t c : *letters)  // what XML 1.0 cannot hold, and line breaks
        if (c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0xfffe || c == 0xffff)
            throw bad_request(
                "text: it contains the control character U+{:04X}; write one line of "
                "letters",
                static_cast<std::uint32_t>(c));
    return *letters;
}

std::string codes_of(const std::vector<char32_t>& letters) {
    std::string codes;
    for (const char32_t c : letters)
        codes += fmt::format("{}U+{:04X}", codes.empty() ? "" : ", ",
                             static_cast<std::uint32_t>(c));
    return codes;
}

Font font_for(const std::string& asked, const std::vector<char32_t>& letters,
              Progress& progress) {
    const Font font = installed_font(asked);
    if (!is_named(font, asked))
        progress.warn(
            fmt::format("font '{}' is not installed: '{}' is used instead; fc-list lists "
                        "the installed fonts",
                        asked, font.name));
    if (const auto none = without_any_shape(letters); !none.empty())
        throw bad_request(
            "text: no installed font has a shape for {}; install one that has",
            codes_of(none));
    if (const auto missing = without_shape(font, letters); !missing.empty())
        progress.warn(fmt::format(
            "font '{}' has no shape for {}: the shape of another font is used", font.name,
            codes_of(missing)));
    return font;
}

// A rectangle of the drawing, in its units. The text is centred on (0, 0).
struct Box {
    double left, top, width, height;
};

std::string drawing(const std::string& text, const Font& font, const Box& page) {
    return fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="{} {} {} {}">)"
        R"(<text x="0" y="0" text-anchor="middle" font-size="{}" font-family="{}" )"
        R"(font-weight="{}" font-style="{}" font-stretch="{}%">{}</text></svg>)",
        page.left, page.top, page.width, page.height, kEm, escaped(font.family),
        font.weight, font.style, font.stretch, escaped(text));
}

// The rectangle that the letters take. The page is enlarged until all of them fit.
Box ink_of(const std::string& text, const Font& font, std::size_t letters) {
    Box page{0.0, 0.0, kEm * (double(letters) + 2.0), 4.0 * kEm};
    for (int tries = 0; tries < 6; ++tries) {
        page.left = -0.5 * page.width;
        page.top = -0.5 * page.height;
        const double scale =
            std::min(200.0 / kEm, 4096.0 / std::max(page.width, page.height));
        const Field<Rgba8> drawn = drawn_svg(
            "text", drawing(text, font, page), static_cast<int>(page.width * scale),
            static_cast<int>(page.height * scale), SvgEdges::kSmooth);
        int left = drawn.width(), right = -1, top = drawn.height(), bottom = -1;
        for (int y = 0; y < drawn.height(); ++y)
            for (int x = 0; x < drawn.width(); ++x) {
                if (drawn(x, y)[3] < 128) continue;
                left = std::min(left, x);
                right = std::max(right, x);
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
        if (right < 0) throw bad_request("text '{}': it has no visible letter", text);
        if (left > 0 && top > 0 && right < drawn.width() - 1 &&
            bottom < drawn.height() - 1)
            return {page.left + left / scale, page.top + top / scale,
                    (right + 1 - left) / scale, (bottom + 1 - top) / scale};
        page.width *= 1.6;  // wider letters than an em
        page.height *= 1.6;
    }
    throw bad_request("text '{}': its letters are too large to draw; choose another font",
                      text);
}

}  // namespace

Lettering lettering(const std::string& text, const std::string& font,
                    Progress& progress) {
    const std::vector<char32_t> letters = letters_of(text);
    const Font used = font_for(font, letters, progress);
    Box page = ink_of(text, used, letters.size());
    // Casters need light ground before the first letter, and shadows must end on light
    // ground.
    const double margin = 0.08 * std::max(page.width, page.height);
    page = {page.left - margin, page.top - margin, page.width + 2.0 * margin,
            page.height + 2.0 * margin};
    return {drawing(text, used, page), page.width, page.height};
}

}  // namespace cydonia::pareidolia
