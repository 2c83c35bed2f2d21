#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <typeindex>
#include <vector>

#include "config/reader/mistakes.h"
#include "config/reader/units.h"
#include "config/reader/value.h"

namespace cydonia::config {

// What one reading of a document at one frame collects.
struct Reading {
    Files& files;
    double frame = 0.0;
    bool checked = false;  // the document was read before, without a mistake
    std::vector<Mistake> mistakes = {};
    std::set<double> key_frames = {};  // every frame that some value has a key at
    // When true nothing is read: the readers' calls describe the keys instead, and the
    // values do not matter.
    bool describes = false;
    std::vector<std::type_index> open_tables = {};  // that are being described
};

// The canonical text and the files of a part of the document, from which a cache key is
// made.
struct Record {
    std::vector<std::string> lines;
    std::vector<Source> sources;
    std::string text() const;  // sorted: no order matters, not even the readers'
    void append(const std::string& prefix, const Record& part);
};

// A value given as { keys = [[frame, value], ...] }. It is linear between keys and
// constant outside.
struct TrackKey {
    double frame;
    const Value* value;
};
// The keys in the order of their frames: all of them in a first reading, those next to
// the frame in a checked document. Empty after a mistake, which is recorded.
std::vector<TrackKey> track_keys(Reading& reading, const Value& track,
                                 const std::string& path);
// `frame` lies between key `index` and the next one, at `weight` (0 to 1) of the way.
struct TrackPoint {
    std::size_t index;
    double weight;
};
TrackPoint track_point(const std::vector<TrackKey>& keys, double frame);

// Whether a unit reads a whole T, as it does for a colour, which is one value with three
// numbers.
template <class Unit, class T>
concept Gives = requires(const Unit& unit, const Value& value, Files& files) {
    { unit.read(value, files) } -> std::same_as<T>;
};

// Reads a single value or an array of them.
template <class Unit>
struct OneOrMore {
    Unit unit;
};

// The elements of an array of `least` to `most` values; null after a mistake.
const Value::Array* elements(Reading& reading, const Value& value,
                             const std::string& path, std::size_t least,
                             std::size_t most);

inline double mixed(double a, double b, double t) {
    return t == 0.0 ? a : a + t * (b - a);
}
inline Length mixed(const Length& a, const Length& b, double t) {
    return {mixed(a.metres, b.metres, t), mixed(a.fraction, b.fraction, t)};
}

inline std::string element(const std::string& path, std::size_t i) {
    return path + '[' + std::to_string(i) + ']';
}

// read_value() reads `out` from `value`: a single value, one over time, or an array of
// them. It returns false after mistakes, which are recorded.
template <class T, class Unit>
bool read_constant(Reading& reading, const Value& value, const std::string& path, T& out,
                   const Unit& unit) {
    try {
        out = static_cast<T>(unit.read(value, reading.files));
        return true;
    } catch (const Wrong& wrong) {
        reading.mistakes.push_back({value.at, path, wrong.message});
        return false;
    }
}

template <class T, class Unit>
bool read_track(Reading& reading, const Value& track, const std::string& path, T& out,
                const Unit& unit) {
    const auto keys = track_keys(reading, track, path);
    std::vector<T> values(keys.size());
    bool good = !keys.empty();
    for (std::size_t i = 0; i < keys.size(); ++i)
        good &= read_constant(reading, *keys[i].value, element(path + ".keys", i),
                              values[i], unit);
    if (!good) return false;
    const auto [i, weight] = track_point(keys, reading.frame);
    out = weight > 0.0 ? mixed(values[i], values[i + 1], weight) : values[i];
    return true;
}

template <class T, class Unit>
bool read_value(Reading& reading, const Value& value, const std::string& path, T& out,
                const Unit& unit) {
    if constexpr (Unit::kVaries)
        if (value.find("keys")) return read_track(reading, value, path, out, unit);
    return read_constant(reading, value, path, out, unit);
}

template <class T, std::size_t N, class Unit>
requires(!Gives<Unit, std::array<T, N>>) bool read_value(Reading& reading,
                                                         const Value& value,
                                                         const std::string& path,
                                                         std::array<T, N>& out,
                                                         const Unit& unit) {
    const auto* array = elements(reading, value, path, N, N);
    bool good = array != nullptr;
    for (std::size_t i = 0; array && i < N; ++i)
        good &= read_value(reading, (*array)[i], element(path, i), out[i], unit);
    return good;
}

template <class T, class Unit>
requires(!Gives<Unit, std::vector<T>>) bool read_value(Reading& reading,
                                                       const Value& value,
                                                       const std::string& path,
                                                       std::vector<T>& out,
                                                       const Unit& unit) {
    constexpr std::size_t kMost = 4096;
    const auto* array = elements(reading, value, path, 0, kMost);
    bool good = array != nullptr;
    out.assign(array ? array->size() : 0, T{});
    for (std::size_t i = 0; i < out.size(); ++i)
        good &= read_value(reading, (*array)[i], element(path, i), out[i], unit);
    return good;
}

template <class T, class Unit>
bool read_value(Reading& reading, const Value& value, const std::string& path,
                std::vector<T>& out, const OneOrMore<Unit>& unit) {
    if (std::holds_alternative<Value::Array>(value.data))
        return read_value(reading, value, path, out, unit.unit);
    out.assign(1, T{});
    return read_value(reading, value, path, out[0], unit.unit);
}

// schema_of() describes what read_value() accepts for a T.
template <class T, class Unit>
std::string schema_of(const Unit& unit) {
    if constexpr (requires { unit.schema(); }) {
        if constexpr (!Gives<Unit, T> && requires { schema::Elements<T>::kMost; }) {
            using Elements = schema::Elements<T>;
            return schema::array(schema_of<typename Elements::Type>(unit),
                                 Elements::kLeast, Elements::kMost);
        } else {
            return Unit::kVaries ? schema::varying(unit.schema()) : unit.schema();
        }
    } else {
        using One = typename schema::Elements<T>::Type;
        return schema::any_of({schema_of<One>(unit.unit), schema_of<T>(unit.unit)});
    }
}

// note() records a value's line of canonical text, and its file if it has one.
template <class T, class Unit>
void note(Record& record, const std::string& path, const T& value, const Unit& unit) {
    record.lines.push_back(path + " = " + unit.text(value));
    if constexpr (std::is_same_v<T, Source>) record.sources.push_back(value);
}

template <class T, std::size_t N, class Unit>
requires(!Gives<Unit, std::array<T, N>>) void note(Record& record,
                                                   const std::string& path,
                                                   const std::array<T, N>& values,
                                                   const Unit& unit) {
    for (std::size_t i = 0; i < N; ++i) note(record, element(path, i), values[i], unit);
}

template <class T, class Unit>
void note(Record& record, const std::string& path, const std::vector<T>& values,
          const Unit& unit) {
    if (values.empty()) record.lines.push_back(path + " = none");
    for (std::size_t i = 0; i < values.size(); ++i)
        note(record, element(path, i), values[i], unit);
}

template <class T, class Unit>
void note(Record& record, const std::string& path, const std::vector<T>& values,
          const OneOrMore<Unit>& unit) {
    note(record, path, values, unit.unit);
}

template <class T, class Unit>
void note(Record& record, const std::string& path, const std::optional<T>& value,
          const Unit& unit) {
    if (value)
        note(record, path, *value, unit);
    else
        record.lines.push_back(path + " = none");
}

}  // namespace cydonia::config
