#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// A scene file's JSON Schema (draft 7, which editors of TOML read) is made by the readers
// themselves: while a Reading describes, every key that they name leaves its schema.
// Fragments are JSON as text.
namespace cydonia::config {

struct Range;

namespace schema {

std::string json_text(std::string_view text);
std::string number(const Range& range, std::string_view description = {});
std::string whole(std::int64_t low, std::int64_t high);
// Matches a pattern of ECMA 262 when one is given.
std::string text(std::size_t longest, std::string_view pattern = {},
                 std::string_view description = {});
std::string words(const std::vector<std::string>& words);
std::string any_of(const std::vector<std::string>& schemas);
std::string array(const std::string& element, std::size_t least, std::size_t most);
// What `value` describes, or { keys = [[frame, value], ...] }.
std::string varying(const std::string& value);

// A table of keys and their schemas; `required` among them. No others are allowed.
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
