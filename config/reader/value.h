#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cydonia::config {

// Where a key or a value stands: origin 0 is the scene file, origin n the n-th --set.
struct Position {
    int origin = 0;
    int line = 1;
    int column = 1;
    auto operator<=>(const Position&) const = default;
};

// A TOML document as plain values that remember where they stand.
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

// "the text 'abc'", "the number 3.5", "a table": for messages about wrong types.
std::string described(const Value& value);

}  // namespace cydonia::config
