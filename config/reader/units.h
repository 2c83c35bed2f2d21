#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "config/reader/mistakes.h"
#include "config/reader/schema.h"
#include "config/reader/value.h"
#include "field/enum_names.h"
#include "field/length.h"
#include "field/source.h"

namespace cydonia::config {

// A unit is a type that reads and checks one value of a scene file and writes it in
// canonical form:
//   T read(const Value&, Files&) const  throws Wrong
//   std::string text(const T&) const    full precision, equal for equal values
//   std::string schema() const          what it takes, as JSON Schema (schema.h)
//   static constexpr bool kVaries       may be given as keys over time

// Opens the files that a scene names, each of them once.
class Files {
  public:
    explicit Files(std::filesystem::path folder)
        : folder_(folder.empty() ? "." : std::move(folder)) {}
    // Opens a path relative to the scene's folder, or to the user's home as "~/a.tif".
    // Throws Wrong.
    const Source& open(const std::string& name);
    // The names of the files that match a pattern such as "dems/*.tif", at most `most`.
    std::vector<std::string> matching(const std::string& pattern, std::size_t most) const;

  private:
    std::variant<Source, Wrong> opened(const std::string& name) const;

    std::filesystem::path folder_;
    std::map<std::string, std::variant<Source, Wrong>> opened_;
};

struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_in = true, high_in = true;  // the limits themselves are allowed

    bool contains(double x) const {
        return (low_in ? x >= low : x > low) && (high_in ? x <= high : x < high);
    }
};

constexpr Range any() { return {}; }
constexpr Range above(double low) { return {.low = low, .low_in = false}; }
constexpr Range at_least(double low) { return {.low = low}; }
constexpr Range from(double low, double high) { return {low, high}; }
constexpr Range above_to(double low, double high) { return {low, high, false, true}; }
constexpr Range between(double low, double high) { return {low, high, false, false}; }

// A finite number.
struct Number {
    Range range;
    static constexpr bool kVaries = true;
    double read(const Value& value, Files&) const;
    std::string text(double number) const;
    std::string schema() const;
};

// Degrees in the file, radians outside.
struct Degrees {
    Range range;  // degrees
    static constexpr bool kVaries = true;
    double read(const Value& value, Files&) const;
    std::string text(double radians) const;
    std::string schema() const;
};

// Metres as a number, or a share of the terrain's width as "5.5 %".
struct LengthUnit {
    Range range;  // of the number as written
    static constexpr bool kVaries = true;
    Length read(const Value& value, Files&) const;
    std::string text(const Length& length) const;
    std::string schema() const;
};

// A whole number, the same in every frame.
struct Whole {
    std::int64_t low, high;
    static constexpr bool kVaries = false;
    std::int64_t read(const Value& value, Files&) const;
    std::string text(std::int64_t number) const;
    std::string schema() const;
};

// One line of text without control characters.
struct Text {
    std::size_t longest = 256;
    static constexpr bool kVaries = false;
    std::string read(const Value& value, Files&) const;
    std::string text(const std::string& text) const;
    std::string schema() const;
};

// A word that may name a file: letters, digits, '_' and '-', at most 64.
struct Word {
    static constexpr bool kVaries = false;
    std::string read(const Value& value, Files&) const;
    std::string text(const std::string& text) const;
    std::string schema() const;
};

// true or false.
struct Flag {
    static constexpr bool kVaries = false;
    bool read(const Value& value, Files&) const;
    std::string text(bool flag) const { return flag ? "true" : "false"; }
    std::string schema() const;
};

// A colour of a drawing in sRGB: "#rrggbb" or a basic colour name of CSS.
struct Colour {
    using Rgb = std::array<std::uint8_t, 3>;
    static constexpr bool kVaries = false;
    Rgb read(const Value& value, Files&) const;
    std::string text(const Rgb& rgb) const;
    std::string schema() const;
};

// A path, absolute or relative to the scene file. Its canonical text is the file's
// content hash.
struct File {
    static constexpr bool kVaries = false;
    Source read(const Value& value, Files& files) const;
    std::string text(const Source& source) const;
    std::string schema() const;
};

// The index of a value in the list of names. Throws Wrong with a suggestion.
std::size_t named(const Value& value, const std::vector<std::string>& names);

template <class E>
struct OneOf {
    std::vector<Name<E>> names;
    static constexpr bool kVaries = false;

    std::vector<std::string> words() const {
        std::vector<std::string> words;
        for (const auto& name : names) words.emplace_back(name.name);
        return words;
    }
    E read(const Value& value, Files&) const {
        return names[named(value, words())].value;
    }
    std::string schema() const { return schema::words(words()); }
    std::string text(const E& wanted) const {
        for (const auto& [name, value] : names)
            if (value == wanted) return std::string(name);
        return "?";
    }
};

template <class E, std::size_t N>
OneOf<E> one_of(const Name<E> (&names)[N]) {
    return {{std::begin(names), std::end(names)}};
}

}  // namespace cydonia::config
