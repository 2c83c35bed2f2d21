#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace cydonia {

// A hash of everything that a step or terrain is made from. Equal keys, equal results.
using Key = std::uint64_t;

// Makes a key from values. Each is appended with its type and, if that varies, its
// length, so that different lists of values never give the same bytes.
class KeyBuilder {
  public:
    // `what` names the kind of thing that gets the key: "check", "frame".
    explicit KeyBuilder(std::string_view what) { add(what); }

    KeyBuilder& add(std::string_view text) {
        append('s', text.size());
        bytes_.append(text);
        return *this;
    }
    KeyBuilder& add(double value) {
        append('d', value);
        return *this;
    }
    template <std::integral T>
    KeyBuilder& add(T value) {
        append('i', static_cast<std::uint64_t>(value));
        return *this;
    }
    template <class E>
    requires std::is_enum_v<E> KeyBuilder& add(E value) {
        return add(static_cast<std::int64_t>(value));
    }
    template <class T>
    KeyBuilder& add(const std::optional<T>& value) {
        append('o', value.has_value());
        return value ? add(*value) : *this;
    }
    template <class T>
    KeyBuilder& add(const std::vector<T>& values) {
        append('v', values.size());
        for (const T& value : values) add(value);
        return *this;
    }

    Key key() const;

  private:
    template <class T>
    void append(char type, const T& value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes_.push_back(type);
        bytes_.append(raw, sizeof raw);
    }
    std::string bytes_;
};

// The 64-bit XXH3 hash.
std::uint64_t hash_of_bytes(std::string_view bytes);
// The same of a file's bytes; 0 if it is missing.
std::uint64_t hash_of_file(const std::filesystem::path& file);

// The key as sixteen hexadecimal digits.
std::string hex(Key key);

}  // namespace cydonia
