#include "field/font.h"

#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <optional>
#include <tuple>

#include "field/error.h"
#include "field/released.h"

namespace cydonia {
namespace {

using Pattern = std::unique_ptr<FcPattern, Released<FcPatternDestroy>>;
using Objects = std::unique_ptr<FcObjectSet, Released<FcObjectSetDestroy>>;
using Fonts = std::unique_ptr<FcFontSet, Released<FcFontSetDestroy>>;

bool equal_but_for_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, [](unsigned char x, unsigned char y) {
        return std::tolower(x) == std::tolower(y);
    });
}

std::string text_of(const FcPattern* pattern, const char* object, int index = 0) {
    FcChar8* text = nullptr;
    return FcPatternGetString(pattern, object, index, &text) == FcResultMatch
               ? reinterpret_cast<const char*>(text)
               : "";
}

double number_of(const FcPattern* pattern, const char* object, double otherwise) {
    double number = otherwise;
    FcPatternGetDouble(pattern, object, 0, &number);
    return number;
}

Font font_of(const FcPattern* pattern) {
    Font font;
    font.family = text_of(pattern, FC_FAMILY);
    font.name = text_of(pattern, FC_FULLNAME);
    if (font.name.empty()) font.name = font.family + ' ' + text_of(pattern, FC_STYLE);
    font.file = text_of(pattern, FC_FILE);
    const int slant = static_cast<int>(number_of(pattern, FC_SLANT, FC_SLANT_ROMAN));
    font.style = slant == FC_SLANT_ROMAN    ? "normal"
                 : slant == FC_SLANT_ITALIC ? "italic"
                                            : "oblique";
    const double weight = number_of(pattern, FC_WEIGHT, FC_WEIGHT_REGULAR);
    font.weight = std::clamp(static_cast<int>(FcWeightToOpenTypeDouble(weight)), 1, 1000);
    font.stretch =
        std::clamp(static_cast<int>(number_of(pattern, FC_WIDTH, 100)), 1, 999);
    return font;
}

// How well a font fits a name, where 0 is best; none when it does not fit.
std::optional<int> fit(const FcPattern* pattern, std::string_view asked) {
    for (int i = 0; !text_of(pattern, FC_FULLNAME, i).empty(); ++i)
        if (equal_but_for_case(text_of(pattern, FC_FULLNAME, i), asked)) return 0;
    for (int i = 0; !text_of(pattern, FC_FAMILY, i).empty(); ++i) {
        const std::string family = text_of(pattern, FC_FAMILY, i);
        for (int k = 0; !text_of(pattern, FC_STYLE, k).empty(); ++k)
            if (equal_but_for_case(family + ' ' + text_of(pattern, FC_STYLE, k), asked))
                return 1;
        if (equal_but_for_case(family, asked)) return 2;
    }
    return std::nullopt;
}

std::optional<Font> font_named(const std::string& asked) {
    const Pattern all(FcPatternCreate());
    const Objects objects(FcObjectSetBuild(FC_FAMILY, FC_FULLNAME, FC_STYLE, FC_FILE,
                                           FC_WEIGHT, FC_SLANT, FC_WIDTH, nullptr));
    const Fonts fonts(FcFontList(nullptr, all.get(), objects.get()));
    // When only a family is asked for, its upright font of regular weight and width is
    // best. The file's name decides between equals.
    using Rank = std::tuple<int, bool, int, int, std::string>;
    std::optional<std::pair<Rank, Font>> best;
    for (int i = 0; fonts && i < fonts->nfont; ++i) {
        const auto fits = fit(fonts->fonts[i], asked);
        if (!fits) continue;
        const Font font = font_of(fonts->fonts[i]);
        const Rank rank{*fits, font.style != "normal", std::abs(font.weight - 400),
                        std::abs(font.stretch - 100), font.file};
        if (!best || rank < best->first) best = {rank, font};
    }
    if (!best) return std::nullopt;
    return best->second;
}

Font substitute_for(const std::string& asked) {
    const Pattern pattern(FcPatternCreate());
    FcPatternAddString(pattern.get(), FC_FAMILY,
                       reinterpret_cast<const FcChar8*>(asked.c_str()));
    FcConfigSubstitute(nullptr, pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    FcResult result = FcResultNoMatch;
    const Pattern match(FcFontMatch(nullptr, pattern.get(), &result));
    if (!match || text_of(match.get(), FC_FILE).empty())
        throw failure("no font is installed; install one (Debian: fonts-dejavu-core)");
    return font_of(match.get());
}

template <class Wanted>
std::vector<char32_t> kept(const std::vector<char32_t>& characters,
                           const Wanted& wanted) {
    std::vector<char32_t> result;
    for (const char32_t c : characters)
        if (wanted(c) && std::ranges::find(result, c) == result.end())
            result.push_back(c);
    return result;
}

}  // namespace

bool is_named(const Font& font, std::string_view asked) {
    return equal_but_for_case(font.name, asked) || equal_but_for_case(font.family, asked);
}

Font installed_font(const std::string& asked) {
    if (auto font = font_named(asked)) {
        if (!is_named(*font, asked)) font->name = asked;  // by family and style
        return *font;
    }
    return substitute_for(asked);
}

std::vector<char32_t> without_shape(const Font& font,
                                    const std::vector<char32_t>& characters) {
    int faces = 0;
    const Pattern pattern(FcFreeTypeQuery(
        reinterpret_cast<const FcChar8*>(font.file.c_str()), 0, nullptr, &faces));
    FcCharSet* shapes = nullptr;
    if (!pattern ||
        FcPatternGetCharSet(pattern.get(), FC_CHARSET, 0, &shapes) != FcResultMatch)
        return {};
    return kept(characters, [&](char32_t c) { return !FcCharSetHasChar(shapes, c); });
}

std::vector<char32_t> without_any_shape(const std::vector<char32_t>& characters) {
    const Pattern all(FcPatternCreate());
    const Objects objects(FcObjectSetBuild(FC_CHARSET, nullptr));
    const Fonts fonts(FcFontList(nullptr, all.get(), objects.get()));
    return kept(characters, [&](char32_t c) {
        for (int i = 0; fonts && i < fonts->nfont; ++i) {
            FcCharSet* shapes = nullptr;
            if (FcPatternGetCharSet(fonts->fonts[i], FC_CHARSET, 0, &shapes) ==
                    FcResultMatch &&
                FcCharSetHasChar(shapes, c))
                return false;
        }
        return true;
    });
}

}  // namespace cydonia
