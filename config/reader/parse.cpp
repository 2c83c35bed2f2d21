#include "config/reader/parse.h"

#include <fmt/format.h>

#include "config/reader/nesting.h"
#include "field/error.h"

// The only file that includes toml++, which takes seconds to compile.
#include <toml++/toml.h>

namespace cydonia::config {
namespace {

Position position(const toml::source_position& at, int origin) {
    // A table that exists only by its children ([terrain] by [[terrain.stage]]) has no
    // position.
    return {origin, at.line ? static_cast<int>(at.line) : 1,
            at.column ? static_cast<int>(at.column) : 1};
}

Value value_of(const toml::node& node, int origin);

Value::Table table_of(const toml::table& table, int origin) {
    Value::Table entries;
    for (const auto& [key, node] : table)
        entries.push_back({std::string(key.str()), position(key.source().begin, origin),
                           value_of(node, origin)});
    return entries;
}

Value::Array array_of(const toml::array& array, int origin) {
    Value::Array values;
    for (const toml::node& node : array) values.push_back(value_of(node, origin));
    return values;
}

std::string text_of(const toml::date& date) {
    return fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day);
}

Value value_of(const toml::node& node, int origin) {
    Value value{position(node.source().begin, origin), Value::Moment{}};
    node.visit([&](const auto& n) {
        if constexpr (toml::is_table<decltype(n)>)
            value.data = table_of(n, origin);
        else if constexpr (toml::is_array<decltype(n)>)
            value.data = array_of(n, origin);
        else if constexpr (toml::is_date<decltype(n)>)
            value.data = Value::Moment{text_of(n.get())};
        else if constexpr (!toml::is_chronological<decltype(n)>)
            value.data = n.get();
    });
    return value;
}

}  // namespace

Value parse(std::string_view text, std::string_view name, int origin) {
    if (const auto deep = too_deep(text))
        throw bad_request("{}:{}:{}: nested too deeply", name, deep->line, deep->column);
    try {
        const toml::table table = toml::parse(text, name);
        return {{origin, 1, 1}, table_of(table, origin)};
    } catch (const toml::parse_error& error) {
        const Position at = position(error.source().begin, origin);
        throw bad_request("{}:{}:{}: {}", name, at.line, at.column, error.description());
    }
}

}  // namespace cydonia::config
