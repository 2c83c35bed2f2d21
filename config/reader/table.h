#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "config/reader/reading.h"

namespace cydonia::config {

// A table of a scene file while it is read into a struct. Every call names a key, notes
// it as known, replaces the default by the file's value and writes canonical text.
// Mistakes are recorded and reading continues. One function for each struct, `void
// read(Table&, Struct&)`, lists its fields.
class Table {
  public:
    // When `value` is null the table is absent, and everything keeps its default.
    Table(Reading& reading, const Value* value, Position at, std::string path = {});

    // Reads a value, or an std::array or std::vector of values.
    template <class T, class Unit>
    void field(std::string_view key, T& out, const Unit& unit);
    // `none` is a word that stands for no value, such as "auto".
    template <class T, class Unit>
    void field(std::string_view key, std::optional<T>& out, const Unit& unit,
               std::string_view none = {});
    // Reads a key that must be there. Returns whether it is there and could be read.
    template <class T, class Unit>
    bool required(std::string_view key, T& out, const Unit& unit);

    // Reads a table within this one by read(Table&, T&, context...), and an optional
    // table only when it is there.
    template <class T, class... Context>
    void table(std::string_view key, T& out, Context&&... context);
    template <class T, class... Context>
    void table(std::string_view key, std::optional<T>& out, Context&&... context);
    // Reads at most `most` tables [[key]].
    template <class T, class... Context>
    void tables(std::string_view key, std::vector<T>& out, std::size_t most,
                Context&&... context);

    // Notes a file that the scene does not name itself as if it stood under `key`.
    std::optional<Source> shipped(const std::string& key,
                                  const std::filesystem::path& file);

    // Records `message` at the first of `keys` that the file has, unless `holds`. Ignored
    // when one of the keys could not be read.
    void check(bool holds, std::initializer_list<std::string_view> keys,
               const std::string& message);

    // Unless `use`, these keys have no effect and are mistakes: "only for kind = ...".
    void only_if(bool use, std::initializer_list<std::string_view> keys,
                 std::string_view condition);
    // Two tables [[tables_key]] with the same text under `key` are a mistake.
    void unique(std::string_view tables_key, std::string_view key);

    bool has(std::string_view key) const { return value_ && value_->find(key); }
    // The canonical text and the files of what was read so far, with paths relative to
    // this table.
    const Record& record() const { return record_; }
    // Records the keys that no call has named.
    void report_unknown() const;
    void ignore_unknown() { ignore_unknown_ = true; }

    // The JSON Schema of this table from the readers' calls, while Reading::describes is
    // true.
    bool describes() const { return reading_.describes; }
    std::string schema() const;
    // Describes a table whose `key` is `name`, with the further keys that `read` reads.
    void variant(std::string_view key, std::string_view name,
                 const std::function<void(Table&)>& read);

  private:
    const Value* find(std::string_view key);  // and note it as known
    void describe(std::string_view key, std::string schema, bool required = false);
    template <class T, class... Context>
    std::string described_child(Context&&... context);
    Position position_of(std::string_view key) const;
    std::string path_of(std::string_view key) const;
    void mistake(std::string_view key, std::string message);
    void missing(std::string_view key, const std::vector<std::string>& names);
    bool is_table(std::string_view key, const Value& value);
    const Value::Array* array_of_tables(std::string_view key, std::size_t most);
    template <class T, class... Context>
    void read_child(const Value* value, Position at, const std::string& name, T& out,
                    Context&&... context);

    Reading& reading_;
    Record record_;
    const Value* value_;
    Position at_;
    std::string path_;  // "terrain.stage[0]"
    bool ignore_unknown_ = false;
    std::vector<std::string> known_;
    std::vector<schema::Key> keys_;      // described, in the readers' order
    std::vector<std::string> variants_;  // likewise; schemas
    std::set<std::string, std::less<>> failed_;
};

template <class T, class Unit>
void Table::field(std::string_view key, T& out, const Unit& unit) {
    if (describes()) describe(key, schema_of<T>(unit));
    if (const Value* value = find(key))
        if (!read_value(reading_, *value, path_of(key), out, unit)) failed_.emplace(key);
    note(record_, std::string(key), out, unit);
}

template <class T, class Unit>
void Table::field(std::string_view key, std::optional<T>& out, const Unit& unit,
                  std::string_view none) {
    if (describes())
        describe(key, none.empty()
                          ? schema_of<T>(unit)
                          : schema::any_of({schema_of<T>(unit),
                                            schema::words({std::string(none)})}));
    if (const Value* value = find(key)) {
        const auto* word = std::get_if<std::string>(&value->data);
        if (word && !none.empty() && *word == none)
            out.reset();
        else if (word && !none.empty() && !word->ends_with('%'))  // a share is text too
            mistake(key, "expected a number or \"" + std::string(none) + "\", found " +
                             described(*value));
        else if (!read_value(reading_, *value, path_of(key), out.emplace(), unit))
            failed_.emplace(key);
    }
    note(record_, std::string(key), out, unit);
}

template <class T, class Unit>
bool Table::required(std::string_view key, T& out, const Unit& unit) {
    if (describes()) {
        describe(key, schema_of<T>(unit), true);
        return true;
    }
    if (has(key)) {
        field(key, out, unit);
    } else {
        find(key);
        if constexpr (requires { unit.words(); })
            missing(key, unit.words());
        else
            missing(key, {});
    }
    return !failed_.contains(key);
}

template <class T, class... Context>
void Table::read_child(const Value* value, Position at, const std::string& name, T& out,
                       Context&&... context) {
    Table child(reading_, value, at, path_of(name));
    read(child, out, context...);
    if (describes()) describe(name, child.schema());
    child.report_unknown();
    record_.append(name, child.record_);
}

// Tables that contain tables of their own kind are described three levels deep.
template <class T, class... Context>
std::string Table::described_child(Context&&... context) {
    constexpr int kDeepest = 3;
    if (std::ranges::count(reading_.open_tables, std::type_index(typeid(T))) >= kDeepest)
        return R"({"type":"object"})";
    reading_.open_tables.emplace_back(typeid(T));
    Table child(reading_, nullptr, at_, path_);
    T out{};
    read(child, out, context...);
    reading_.open_tables.pop_back();
    return child.schema();
}

template <class T, class... Context>
void Table::table(std::string_view key, T& out, Context&&... context) {
    const Value* value = find(key);
    if (!value || is_table(key, *value))
        read_child(value, position_of(key), std::string(key), out, context...);
}

template <class T, class... Context>
void Table::table(std::string_view key, std::optional<T>& out, Context&&... context) {
    if (describes()) return describe(key, described_child<T>(context...));
    const Value* value = find(key);
    if (!value)
        record_.lines.push_back(std::string(key) + " = none");
    else if (is_table(key, *value))
        read_child(value, position_of(key), std::string(key), out.emplace(), context...);
}

template <class T, class... Context>
void Table::tables(std::string_view key, std::vector<T>& out, std::size_t most,
                   Context&&... context) {
    if (describes())
        return describe(key, schema::array(described_child<T>(context...), 0, most));
    const Value::Array* array = array_of_tables(key, most);
    if (!array) return;
    out.assign(array->size(), T{});
    for (std::size_t i = 0; i < out.size(); ++i)
        read_child(&(*array)[i], (*array)[i].at, element(std::string(key), i), out[i],
                   context...);
}

}  // namespace cydonia::config
