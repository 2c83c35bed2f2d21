#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The readers themselves make a scene file's JSON Schema (draft 7, which editors of TOML
// read): while Reading::describes is true, every key that they name records its schema.
// Fragments are JSON as text.
namespace cydonia::config {

struct Range;

namespace schema {

std::string json_text(std::string_view text);
std::string number(const Range& range, std::string_view description = {});
std::string whole(std::int64_t low, std::int64_t high);
// The schema of a text; `pattern` is one of ECMA 262, or empty.
std::string text(std::size_t longest, std::string_view pattern = {},
                 std::string_view description = {});
std::string words(const std::vector<std::string>& words);
std::string any_of(const std::vector<std::string>& schemas);
std::string array(const std::string& element, std::size_t least, std::size_t most);
// The schema of a value that `value` describes, or of { keys = [[frame, value], ...] }.
std::string varying(const std::string& value);

// The schema of a table with these keys and no others.
struct Key {
    std::string name, schema;
    bool required = false;
};
std::string table(const std::vector<Key>& keys);

}  // namespace schema

template <class Unit>
struct OneOrMore;

namespace schema {

template <class T>
struct Elements {};
template <class T, std::size_t N>
struct Elements<std::array<T, N>> {
    using Type = T;
    static constexpr std::size_t kLeast = N, kMost = N;
};
template <class T>
struct Elements<std::vector<T>> {
    using Type = T;
    static constexpr std::size_t kLeast = 0, kMost = 4096;
};

}  // namespace schema

}  // namespace cydonia::config
