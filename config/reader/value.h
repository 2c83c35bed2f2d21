#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cydonia::config {

// The position of a key or a value. Origin 0 is the scene file, and origin n is the n-th
// --set.
struct Position {
    int origin = 0;
    int line = 1;
    int column = 1;
    auto operator<=>(const Position&) const = default;
};

// A TOML document as plain values that know their positions.
struct Value {
    struct Entry;
    struct Moment {             // a date or a time
        std::string date = {};  // "2026-06-21"; empty when there is a time
    };
    using Array = std::vector<Value>;
    using Table = std::vector<Entry>;

    Position at;
    std::variant<Table, Array, std::string, double, std::int64_t, bool, Moment> data;

    const Value* find(std::string_view key) const;  // null: none, or not a table
};

struct Value::Entry {
    std::string key;
    Position at;  // of the key
    Value value;
};

// A description such as "the text 'abc'", "the number 3.5" or "a table", for messages
// about wrong types.
std::string described(const Value& value);

}  // namespace cydonia::config
