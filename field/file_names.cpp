#include "field/file_names.h"

#include <fmt/core.h>
#include <xxhash.h>

#include <algorithm>
#include <map>

#include "field/utf8.h"

namespace cydonia {
namespace {

constexpr std::size_t kLongest = 64;     // bytes
constexpr std::size_t kHashDigits = 16;  // of 64 bits
constexpr std::size_t kLongestStem = kLongest - kHashDigits - 1;

bool is_small(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

// What can be read of it: signs, and all that is no UTF-8, are '-'.
std::string readable(std::string_view text) {
    const bool is_utf8 = characters_of(text).has_value();
    std::string stem(text);
    for (char& c : stem)
        if (!is_small(c) && !is_capital(c) && (is_ascii(c) || !is_utf8)) c = '-';
    return stem;
}

// Its first bytes, and no part of a character.
std::string cut(std::string stem, std::size_t longest) {
    if (stem.size() <= longest) return stem;
    while (longest > 0 && (static_cast<unsigned char>(stem[longest]) & 0xc0) == 0x80)
        --longest;
    stem.resize(longest);
    return stem;
}

std::string in_small_letters(std::string text) {
    for (char& c : text)
        if (is_capital(c)) c = static_cast<char>(c - 'A' + 'a');
    return text;
}

}  // namespace

std::string file_name_of(std::string_view text) {
    if (!text.empty() && text.size() <= kLongest && std::ranges::all_of(text, is_small))
        return std::string(text);
    return fmt::format("{}~{:016x}", cut(readable(text), kLongestStem),
                       XXH3_64bits(text.data(), text.size()));
}

std::vector<std::string> file_names_of(const std::vector<std::string>& texts) {
    std::map<std::string, int> wanted;  // how many texts want a name without a hash
    for (const std::string& text : texts) ++wanted[in_small_letters(readable(text))];
    std::vector<std::string> names;
    for (const std::string& text : texts) {
        const std::string plain = readable(text);
        const bool is_free = wanted[in_small_letters(plain)] == 1 && !text.empty() &&
                             plain.size() <= kLongest &&
                             std::ranges::all_of(text, is_ascii);
        names.push_back(is_free ? plain : file_name_of(text));
    }
    return names;
}

}  // namespace cydonia
