#include "config/reader/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cydonia::config {

const Value* Value::find(std::string_view key) const {
    const auto* table = std::get_if<Table>(&data);
    if (!table) return nullptr;
    const auto entry = std::ranges::find(*table, key, &Entry::key);
    return entry == table->end() ? nullptr : &entry->value;
}

std::string described(const Value& value) {
    struct Visitor {
        std::string operator()(const Value::Table&) const { return "a table"; }
        std::string operator()(const Value::Array& array) const {
            return array.empty() ? "an empty array"
                                 : fmt::format("an array of {}", array.size());
        }
        std::string operator()(const std::string& text) const {
            if (text.size() > 60) return "a long text";
            return fmt::format("the text '{}'", text);
        }
        std::string operator()(double number) const {
            const bool whole = std::trunc(number) == number && std::abs(number) < 1e15;
            return fmt::format("the number {}{}", number, whole ? ".0" : "");
        }
        std::string operator()(std::int64_t number) const {
            return fmt::format("the number {}", number);
        }
        std::string operator()(bool truth) const { return truth ? "true" : "false"; }
        std::string operator()(const Value::Moment& moment) const {
            return moment.date.empty() ? "a time" : "the date " + moment.date;
        }
    };
    return std::visit(Visitor{}, value.data);
}

}  // namespace cydonia::config
