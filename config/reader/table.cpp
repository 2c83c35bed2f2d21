#include "config/reader/table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cydonia::config {
namespace {

// "terrain.stage[0].image" as TOML writes its header: "terrain.stage.image".
std::string without_indices(std::string_view path) {
    std::string name;
    bool inside = false;
    for (const char c : path) {
        inside = inside || c == '[';
        if (!inside) name += c;
        inside = inside && c != ']';
    }
    return name;
}

}  // namespace

Table::Table(Reading& reading, const Value* value, Position at, std::string path)
    : reading_(reading), value_(value), at_(at), path_(std::move(path)) {}

void Table::check(bool holds, std::initializer_list<std::string_view> keys,
                  const std::string& message) {
    if (holds || std::ranges::any_of(keys, [&](auto k) { return failed_.contains(k); }))
        return;
    const auto present = std::ranges::find_if(keys, [&](auto k) { return has(k); });
    mistake(present == keys.end() ? *keys.begin() : *present, message);
}

void Table::only_if(bool use, std::initializer_list<std::string_view> keys,
                    std::string_view condition) {
    for (const auto key : keys)
        if (!use && has(key)) mistake(key, fmt::format("only for {}", condition));
}

void Table::unique(std::string_view tables_key, std::string_view key) {
    const Value* tables = value_ ? value_->find(tables_key) : nullptr;
    const auto* array = tables ? std::get_if<Value::Array>(&tables->data) : nullptr;
    std::set<std::string> seen;
    for (std::size_t i = 0; array && i < array->size(); ++i) {
        const Value* value = (*array)[i].find(key);
        const auto* text = value ? std::get_if<std::string>(&value->data) : nullptr;
        if (text && !seen.insert(*text).second)
            reading_.mistakes.push_back(
                {value->at, fmt::format("{}.{}", element(path_of(tables_key), i), key),
                 fmt::format("'{}' is taken by another one", *text)});
    }
}

std::optional<Source> Table::shipped(const std::string& key,
                                     const std::filesystem::path& file) {
    try {
        const Source& source = reading_.files.open(file.string());
        note(record_, key, source, File{});
        return source;
    } catch (const Wrong& wrong) {
        mistake(key, wrong.message);
        return std::nullopt;
    }
}

void Table::report_unknown() const {
    if (!value_ || ignore_unknown_) return;
    for (const auto& [key, at, value] : std::get<Value::Table>(value_->data))
        if (std::ranges::find(known_, key) == known_.end())
            reading_.mistakes.push_back(
                {at, path_,
                 fmt::format("unknown key '{}'{}", key, suggestion(key, known_))});
}

const Value* Table::find(std::string_view key) {
    known_.emplace_back(key);
    return value_ ? value_->find(key) : nullptr;
}

void Table::describe(std::string_view key, std::string schema, bool required) {
    if (std::ranges::find(keys_, key, &schema::Key::name) == keys_.end())
        keys_.push_back({std::string(key), std::move(schema), required});
}

void Table::variant(std::string_view key, std::string_view name,
                    const std::function<void(Table&)>& read) {
    Table own(reading_, nullptr, at_, path_);
    own.describe(key, schema::words({std::string(name)}), true);
    read(own);
    variants_.push_back(own.schema());
}

std::string Table::schema() const {
    return variants_.empty() ? schema::table(keys_) : schema::any_of(variants_);
}

Position Table::position_of(std::string_view key) const {
    const Value* value = value_ ? value_->find(key) : nullptr;
    return value ? value->at : at_;
}

std::string Table::path_of(std::string_view key) const {
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

void Table::mistake(std::string_view key, std::string message) {
    reading_.mistakes.push_back({position_of(key), path_of(key), std::move(message)});
}

void Table::missing(std::string_view key, const std::vector<std::string>& names) {
    const auto known = fmt::format("; known: {}", fmt::join(names, ", "));
    reading_.mistakes.push_back(
        {at_, path_, fmt::format("missing key '{}'{}", key, names.empty() ? "" : known)});
    failed_.emplace(key);
}

bool Table::is_table(std::string_view key, const Value& value) {
    if (std::holds_alternative<Value::Table>(value.data)) return true;
    mistake(key, fmt::format("expected a table, found {}", described(value)));
    failed_.emplace(key);
    return false;
}

const Value::Array* Table::array_of_tables(std::string_view key, std::size_t most) {
    const Value* value = find(key);
    if (!value) return nullptr;
    const std::string path = path_of(key);
    const std::size_t before = reading_.mistakes.size();
    const Value::Array* array = nullptr;
    if (std::holds_alternative<Value::Table>(value->data))
        mistake(key, fmt::format("expected an array of tables; write [[{}]]",
                                 without_indices(path)));
    else
        array = elements(reading_, *value, path, 0, most);
    for (std::size_t i = 0; array && i < array->size(); ++i)
        if (!std::holds_alternative<Value::Table>((*array)[i].data))
            reading_.mistakes.push_back(
                {(*array)[i].at, element(path, i),
                 fmt::format("expected a table, found {}", described((*array)[i]))});
    if (reading_.mistakes.size() == before) return array;
    failed_.emplace(key);
    return nullptr;
}

}  // namespace cydonia::config
