#include "config/reader/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

#include "config/reader/parse.h"
#include "field/error.h"

namespace cydonia::config {
namespace {

constexpr std::size_t kMostSteps = 32;

// "terrain.stage[0].grain" as {"terrain", "stage", "0", "grain"}; empty when malformed.
std::vector<std::string> steps(std::string_view path) {
    std::vector<std::string> found;
    while (true) {
        const bool index = path.starts_with('[');
        if (index) path.remove_prefix(1);
        const std::size_t end =
            std::min(path.find_first_of(index ? "]" : ".["), path.size());
        if (end == 0 || (index && end == path.size()) || found.size() == kMostSteps)
            return {};
        found.emplace_back(path.substr(0, end));
        path.remove_prefix(end + (index ? 1 : 0));
        if (path.empty()) return found;
        if (path.starts_with('.'))
            path.remove_prefix(1);
        else if (!path.starts_with('['))
            return {};
    }
}

std::optional<std::size_t> index_of(std::string_view step) {
    std::size_t index = 0;
    const char* const end = step.data() + step.size();
    const auto [rest, error] = std::from_chars(step.data(), end, index);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return index;
}

Value value_of(const std::string& text, int origin) {
    try {
        Value document = parse("value = " + text, "--set", origin);
        auto& entries = std::get<Value::Table>(document.data);
        if (entries.size() == 1) return std::move(entries.front().value);
    } catch (const Error&) {
        // The value is no TOML, but a word without quotes.
    }
    return {{origin, 1, 1}, text};
}

// The value under `step`, which is added to a table that has none. Throws Wrong.
Value& child(Value& parent, const std::string& step, int origin) {
    const Position here{origin, 1, 1};
    if (auto* table = std::get_if<Value::Table>(&parent.data)) {
        const auto entry = std::ranges::find(*table, step, &Value::Entry::key);
        if (entry != table->end()) return entry->value;
        if (index_of(step))
            throw Wrong{fmt::format("no entry {}; the file has none", step)};
        return table->emplace_back(Value::Entry{step, here, {here, Value::Table{}}})
            .value;
    }
    auto* array = std::get_if<Value::Array>(&parent.data);
    if (!array) throw Wrong{fmt::format("expected a table, found {}", described(parent))};
    const auto index = index_of(step);
    if (!index || *index >= array->size())
        throw Wrong{fmt::format("no entry {}; the file has {}, counted from 0", step,
                                array->size())};
    return (*array)[*index];
}

}  // namespace

std::optional<Mistake> apply_override(Value& document, const std::string& override_text,
                                      int origin) {
    const Position here{origin, 1, 1};
    const std::size_t equals = override_text.find('=');
    const auto path = steps(override_text.substr(0, equals));
    if (equals == std::string::npos || path.empty())
        return Mistake{here, "", "expected KEY=VALUE such as terrain.samples=1024"};
    Value changed = document;  // nothing is left half made when the path leads nowhere
    Value* at = &changed;
    std::string walked;
    try {
        for (const auto& step : path) {
            at = &child(*at, step, origin);
            walked += (walked.empty() ? "" : ".") + step;
        }
    } catch (const Wrong& wrong) {
        return Mistake{here, walked, wrong.message};
    }
    *at = value_of(override_text.substr(equals + 1), origin);
    document = std::move(changed);
    return std::nullopt;
}

}  // namespace cydonia::config
