#include "config/reader/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "config/reader/matching.h"
#include "field/colour_words.h"
#include "field/error.h"
#include "field/utf8.h"
#include "field/vec.h"

namespace cydonia::config {
namespace {

constexpr double kLargestMetres = 1e9, kLargestPercent = 1e5;

std::string text_of(const Range& range, std::string_view unit) {
    std::string text;
    if (std::isfinite(range.low) && std::isfinite(range.high) && range.low_in &&
        range.high_in)
        return fmt::format("{} to {}{}", range.low, range.high, unit);
    if (std::isfinite(range.low))
        text = fmt::format("{} {}", range.low_in ? "at least" : "above", range.low);
    if (std::isfinite(range.high))
        text += fmt::format("{}{} {}", text.empty() ? "" : " and ",
                            range.high_in ? "at most" : "below", range.high);
    return text + std::string(unit);
}

void expect_in(const Range& range, double number, std::string_view unit) {
    if (!range.contains(number))
        throw Wrong{fmt::format("{}{} is out of range; must be {}", number, unit,
                                text_of(range, unit))};
}

Wrong unexpected(std::string_view expected, const Value& value) {
    return {fmt::format("expected {}, found {}", expected, described(value))};
}

double finite(const Value& value, std::string_view expected) {
    if (const auto* whole = std::get_if<std::int64_t>(&value.data))
        return static_cast<double>(*whole);
    const auto* number = std::get_if<double>(&value.data);
    if (!number) throw unexpected(expected, value);
    if (!std::isfinite(*number)) throw Wrong{fmt::format("{} is not finite", *number)};
    return *number;
}

// The number before the sign of "5.5 %".
double percent(const Value& value, std::string_view expected) {
    const auto& text = std::get<std::string>(value.data);
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    std::string_view sign(rest, static_cast<std::size_t>(end - rest));
    sign.remove_prefix(std::min(sign.find_first_not_of(' '), sign.size()));
    if (error != std::errc{} || sign != "%" || !std::isfinite(number))
        throw unexpected(expected, value);
    return number;
}

// In UTF-8 a control character is a byte below the space, or 0x7f.
bool control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

std::string line_of_text(const Value& value, std::size_t longest) {
    const auto* text = std::get_if<std::string>(&value.data);
    if (!text) throw unexpected("text in quotes", value);
    if (text->size() > longest)
        throw Wrong{fmt::format("text of {} bytes is too long; at most {}", text->size(),
                                longest)};
    if (!characters_of(*text)) throw Wrong{"expected text in UTF-8"};
    if (std::ranges::any_of(*text, control))
        throw Wrong{"expected one line of text without control characters"};
    return *text;
}

std::vector<std::string> colour_words() {
    std::vector<std::string> words;
    for (const ColourWord& word : kColourWords) words.emplace_back(word.name);
    return words;
}

}  // namespace

const Source& Files::open(const std::string& name) {
    auto [found, fresh] = opened_.try_emplace(name, Wrong{});
    if (fresh) found->second = opened(name);
    if (const auto* wrong = std::get_if<Wrong>(&found->second)) throw *wrong;
    return std::get<Source>(found->second);
}

std::variant<Source, Wrong> Files::opened(const std::string& name) const {
    const std::filesystem::path named = at_home(name), path = folder_ / named;
    std::error_code ignored;
    if (path != named && !std::filesystem::exists(path, ignored))
        return Wrong{
            fmt::format("cannot open '{}' (looked in {})", name, folder_.string())};
    try {
        return open_source(path);
    } catch (const Error& error) {
        return Wrong{error.what()};
    }
}

std::vector<std::string> Files::matching(const std::string& pattern,
                                         std::size_t most) const {
    return config::matching(folder_, pattern, most);
}

double Number::read(const Value& value, Files&) const {
    const double number = finite(value, "a number");
    expect_in(range, number, "");
    return number;
}

std::string Number::text(double number) const { return fmt::format("{}", number); }

double Degrees::read(const Value& value, Files&) const {
    const double number = finite(value, "an angle in degrees");
    expect_in(range, number, " degrees");
    return radians(number);
}

std::string Degrees::text(double radians) const { return fmt::format("{} rad", radians); }

Length LengthUnit::read(const Value& value, Files&) const {
    constexpr std::string_view kExpected =
        "metres as a number or a share of the width such as \"5.5 %\"";
    const bool share = std::holds_alternative<std::string>(value.data);
    const double number = share ? percent(value, kExpected) : finite(value, kExpected);
    const std::string_view unit = share ? " %" : " m";
    expect_in(range, number, unit);
    const double largest = share ? kLargestPercent : kLargestMetres;
    expect_in(from(-largest, largest), number, unit);
    return share ? of_width(number / 100.0) : metres(number);
}

std::string LengthUnit::text(const Length& length) const {
    return fmt::format("{} m + {} width", length.metres, length.fraction);
}

std::int64_t Whole::read(const Value& value, Files&) const {
    const auto* number = std::get_if<std::int64_t>(&value.data);
    if (!number && value.find("keys"))
        throw Wrong{"a whole number cannot vary in time; expected one number"};
    if (!number) throw unexpected("a whole number", value);
    if (*number < low || *number > high)
        throw Wrong{
            fmt::format("{} is out of range; must be {} to {}", *number, low, high)};
    return *number;
}

std::string Whole::text(std::int64_t number) const { return fmt::format("{}", number); }

std::string Text::read(const Value& value, Files&) const {
    return line_of_text(value, longest);
}

std::string Text::text(const std::string& text) const { return '"' + text + '"'; }

std::string Word::read(const Value& value, Files&) const {
    constexpr std::size_t kLongest = 64;
    const std::string text = line_of_text(value, 256);
    const auto safe = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    if (text.empty() || text.size() > kLongest || !std::ranges::all_of(text, safe))
        throw Wrong{fmt::format(
            "'{}' names files: use 1 to {} letters A-Z a-z, digits, '_' and '-'", text,
            kLongest)};
    return text;
}

std::string Word::text(const std::string& text) const { return text; }

bool Flag::read(const Value& value, Files&) const {
    const auto* flag = std::get_if<bool>(&value.data);
    if (!flag) throw unexpected("true or false", value);
    return *flag;
}

Colour::Rgb Colour::read(const Value& value, Files&) const {
    const std::string text = line_of_text(value, 256);
    if (!text.starts_with('#')) return kColourWords[named(value, colour_words())].value;
    std::uint32_t rgb = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data() + 1, end, rgb, 16);
    if (error != std::errc{} || rest != end || text.size() != 7)
        throw Wrong{
            fmt::format("expected a colour such as \"#d02020\", found '{}'", text)};
    return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
            static_cast<std::uint8_t>(rgb)};
}

std::string Colour::text(const Rgb& rgb) const {
    return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

Source File::read(const Value& value, Files& files) const {
    const std::string name = line_of_text(value, 4096);
    if (name.empty()) throw Wrong{"expected the path of a file, found an empty text"};
    return files.open(name);
}

std::string File::text(const Source& source) const {
    return fmt::format("xxh3 {:016x} of {} bytes", source.hash, source.size);
}

std::string Number::schema() const { return schema::number(range); }

std::string Degrees::schema() const { return schema::number(range, "degrees"); }

// The range also applies to the number of a share, which a schema cannot check.
std::string LengthUnit::schema() const {
    return schema::any_of(
        {schema::number(range, "metres"),
         schema::text(64, "^-?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)? *%$",
                      "a share of the width")});
}

std::string Whole::schema() const { return schema::whole(low, high); }

std::string Text::schema() const { return schema::text(longest); }

std::string Word::schema() const { return schema::text(64, "^[A-Za-z0-9_-]+$"); }

std::string Flag::schema() const { return R"({"type":"boolean"})"; }

std::string Colour::schema() const {
    return schema::any_of(
        {schema::text(7, "^#[0-9a-fA-F]{6}$"), schema::words(colour_words())});
}

std::string File::schema() const { return schema::text(4096, ".", "a file"); }

std::size_t named(const Value& value, const std::vector<std::string>& names) {
    const std::string text = line_of_text(value, 256);
    const auto found = std::ranges::find(names, text);
    if (found == names.end())
        throw Wrong{fmt::format("unknown name '{}'{}", text, suggestion(text, names))};
    return static_cast<std::size_t>(found - names.begin());
}

}  // namespace cydonia::config
