#include "config/reader/nesting.h"

#include <algorithm>

namespace cydonia::config {
namespace {

constexpr int kDeepest = 32;

// The end of the string that begins at `begin`: after its closing quotes, or at the end
// of the line or text if it is not closed, where the parser stops.
std::size_t string_end(std::string_view text, std::size_t begin) {
    const char quote = text[begin];
    const std::string triple(3, quote);
    const bool multi_line = text.substr(begin, 3) == triple;
    for (std::size_t i = begin + (multi_line ? 3 : 1); i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"') {
            ++i;
        } else if (!multi_line && (text[i] == quote || text[i] == '\n')) {
            return i + 1;
        } else if (multi_line && text.substr(i, 3) == triple) {
            i += 3;  // up to two quotes more may stand before the closing three
            for (int more = 0; more < 2 && i < text.size() && text[i] == quote; ++more)
                ++i;
            return i;
        }
    }
    return text.size();
}

Position position_at(std::string_view text, std::size_t offset) {
    const auto before = text.substr(0, offset);
    const auto lines = std::ranges::count(before, '\n');
    const auto line_begin = before.rfind('\n') + 1;  // npos + 1 is 0: the first line
    return {0, static_cast<int>(lines) + 1, static_cast<int>(offset - line_begin) + 1};
}

}  // namespace

std::optional<Position> too_deep(std::string_view text) {
    int brackets = 0, dots = 0;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '"' || c == '\'') {
            i = string_end(text, i);
            continue;
        }
        if (c == '#') {
            i = std::min(text.find('\n', i), text.size());
            continue;
        }
        if (c == '[' || c == '{') ++brackets;
        if ((c == ']' || c == '}') && brackets > 0) --brackets;
        if (c == '.') ++dots;
        if (c == ',' || c == '=' || c == '\n') dots = 0;
        if (brackets > kDeepest || dots > kDeepest) return position_at(text, i);
        ++i;
    }
    return std::nullopt;
}

}  // namespace cydonia::config
