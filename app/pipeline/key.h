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

// A hash of everything that a step or a terrain is made from: equal keys, equal results.
using Key = std::uint64_t;

// Makes every key. Values are appended with their type and, where it varies, their
// length, so that no two lists of values give the same bytes.
class KeyBuilder {
  public:
    // `what` names the kind of thing that the key is of: "check", "frame".
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

// XXH3, 64 bits.
std::uint64_t hash_of_bytes(std::string_view bytes);
// Zero for a missing file, which no finished step was made from.
std::uint64_t hash_of_file(const std::filesystem::path& file);

// Sixteen digits.
std::string hex(Key key);

}  // namespace cydonia
