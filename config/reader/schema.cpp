#include "config/reader/schema.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "config/reader/units.h"

namespace cydonia::config::schema {
namespace {

std::string described(std::string_view description) {
    return description.empty()
               ? ""
               : fmt::format(R"(,"description":{})", json_text(description));
}

}  // namespace

std::string json_text(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

std::string number(const Range& range, std::string_view description) {
    std::string text = R"({"type":"number")";
    if (std::isfinite(range.low))
        text += fmt::format(R"(,"{}":{})", range.low_in ? "minimum" : "exclusiveMinimum",
                            range.low);
    if (std::isfinite(range.high))
        text += fmt::format(R"(,"{}":{})", range.high_in ? "maximum" : "exclusiveMaximum",
                            range.high);
    return text + described(description) + '}';
}

std::string whole(std::int64_t low, std::int64_t high) {
    return fmt::format(R"({{"type":"integer","minimum":{},"maximum":{}}})", low, high);
}

std::string text(std::size_t longest, std::string_view pattern,
                 std::string_view description) {
    std::string text = fmt::format(R"({{"type":"string","maxLength":{})", longest);
    if (!pattern.empty()) text += fmt::format(R"(,"pattern":{})", json_text(pattern));
    return text + described(description) + '}';
}

std::string words(const std::vector<std::string>& words) {
    std::vector<std::string> all;
    for (const std::string& word : words) all.push_back(json_text(word));
    return fmt::format(R"({{"enum":[{}]}})", fmt::join(all, ","));
}

std::string any_of(const std::vector<std::string>& schemas) {
    return fmt::format(R"({{"anyOf":[{}]}})", fmt::join(schemas, ","));
}

std::string array(const std::string& element, std::size_t least, std::size_t most) {
    return fmt::format(R"({{"type":"array","items":{},"minItems":{},"maxItems":{}}})",
                       element, least, most);
}

std::string varying(const std::string& value) {
    constexpr std::size_t kMostKeys = 4096;
    const std::string key =
        fmt::format(R"({{"type":"array","items":[{{"type":"number"}},{}],)"
                    R"("minItems":2,"maxItems":2}})",
                    value);
    return any_of({value, table({{"keys", array(key, 1, kMostKeys), true}})});
}

std::string table(const std::vector<Key>& keys) {
    std::vector<std::string> properties, required;
    for (const Key& key : keys) {
        properties.push_back(fmt::format("{}:{}", json_text(key.name), key.schema));
        if (key.required) required.push_back(json_text(key.name));
    }
    return fmt::format(R"({{"type":"object","properties":{{{}}},"required":[{}],)"
                       R"("additionalProperties":false}})",
                       fmt::join(properties, ","), fmt::join(required, ","));
}

}  // namespace cydonia::config::schema
