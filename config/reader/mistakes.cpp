#include "config/reader/mistakes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cydonia::config {
namespace {

constexpr std::size_t kMostListed = 50;

std::string line_of(const Mistake& mistake, const Origins& origins) {
    const auto [origin, line, column] = mistake.at;
    const auto place =
        origin == 0
            ? fmt::format("{}:{}:{}", origins.file, line, column)
            : fmt::format("--set {}",
                          origins.overrides[static_cast<std::size_t>(origin - 1)]);
    return fmt::format("{}: {}{}{}", place, mistake.path,
                       mistake.path.empty() ? "" : ": ", mistake.message);
}

// The number of letters to change, insert, remove or swap with their neighbour (optimal
// string alignment; Damerau 1964).
std::size_t edits(std::string_view a, std::string_view b) {
    const std::size_t rows = a.size() + 1, columns = b.size() + 1;
    std::vector<std::size_t> cost(rows * columns);
    const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& {
        return cost[i * columns + j];
    };
    for (std::size_t i = 0; i < rows; ++i) at(i, 0) = i;
    for (std::size_t j = 0; j < columns; ++j) at(0, j) = j;
    for (std::size_t i = 1; i < rows; ++i)
        for (std::size_t j = 1; j < columns; ++j) {
            const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
            at(i, j) =
                std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
        }
    return cost.back();
}

}  // namespace

std::string listed(std::vector<Mistake> mistakes, const Origins& origins) {
    std::ranges::stable_sort(mistakes, {}, &Mistake::at);
    const std::size_t more = mistakes.size() - std::min(mistakes.size(), kMostListed);
    mistakes.resize(mistakes.size() - more);
    std::vector<std::string> lines;
    for (const auto& mistake : mistakes) lines.push_back(line_of(mistake, origins));
    if (more > 0) lines.push_back(fmt::format("and {} more", more));
    return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string suggestion(std::string_view word, const std::vector<std::string>& names) {
    constexpr std::size_t kLongestWord = 64;  // longer ones are near nothing
    const std::string* nearest = nullptr;
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    if (word.size() <= kLongestWord)
        for (const std::string& name : names)
            if (const auto cost = edits(word, name); cost < least && cost < name.size()) {
                nearest = &name;
                least = cost;
            }
    if (nearest) return fmt::format("; did you mean '{}'?", *nearest);
    return fmt::format("; known: {}", fmt::join(names, ", "));
}

}  // namespace cydonia::config
