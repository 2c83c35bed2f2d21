#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cydonia {

// One row of an enum's table of names. The table is an array of these beside the enum,
// and the only place where the names stand: scene files, the command line, messages and
// file names all read it.
template <class E>
struct Name {
    std::string_view name;
    E value;
};

template <class E, std::size_t N>
constexpr std::string_view name_in(const Name<E> (&table)[N], E value) {
    for (const Name<E>& row : table)
        if (row.value == value) return row.name;
    return "?";
}

template <class E, std::size_t N>
constexpr std::optional<E> value_in(const Name<E> (&table)[N], std::string_view name) {
    for (const Name<E>& row : table)
        if (row.name == name) return row.value;
    return std::nullopt;
}

template <class E, std::size_t N>
std::vector<E> values_in(const Name<E> (&table)[N]) {
    std::vector<E> values;
    for (const Name<E>& row : table) values.push_back(row.value);
    return values;
}

// "draft, preview or final".
template <class E, std::size_t N>
std::string choices_in(const Name<E> (&table)[N]) {
    std::string text(table[0].name);
    for (std::size_t i = 1; i < N; ++i)
        text.append(i + 1 < N ? ", " : " or ").append(table[i].name);
    return text;
}

// Whether every value from the first has its row, in order: for a static_assert that
// names the last value.
template <class E, std::size_t N>
constexpr bool is_complete(const Name<E> (&table)[N], E last) {
    for (std::size_t i = 0; i < N; ++i)
        if (static_cast<std::size_t>(table[i].value) != i) return false;
    return static_cast<std::size_t>(last) + 1 == N;
}

}  // namespace cydonia
