#include "app/pipeline/key.h"

#include <gtest/gtest.h>

#include <set>

using namespace cydonia;

namespace {

enum class Colour { kRed, kGreen };

Key key_of(const auto&... values) {
    KeyBuilder key("test");
    (key.add(values), ...);
    return key.key();
}

}  // namespace

TEST(Key, EqualValuesGiveEqualKeys) {
    EXPECT_EQ(key_of(1, "a", 0.5), key_of(1, std::string("a"), 0.5));
    EXPECT_NE(KeyBuilder("check").key(), KeyBuilder("trace").key());
}

// No two lists of values run together into one.
TEST(Key, DiffersWhereverTheValuesDo) {
    using Texts = std::vector<std::string>;
    const std::vector<Key> keys = {
        key_of(),
        key_of(""),
        key_of("", ""),
        key_of("ab"),
        key_of("a", "b"),
        key_of("b", "a"),
        key_of("a b"),
        key_of(std::string("a\0b", 3)),
        key_of(1),
        key_of(1, 1),
        key_of(11),
        key_of("1"),
        key_of(1.0),
        key_of(0),
        key_of(std::optional<int>()),
        key_of(std::optional<int>(0)),
        key_of(std::optional<int>(1)),
        key_of(Texts{}),
        key_of(Texts{"a"}),
        key_of(Texts{"a", "b"}),
        key_of(Texts{"a"}, Texts{"b"}),
        key_of(0.1),
        key_of(0.1 + 1e-17, 0),
        key_of(std::uint64_t{1} << 63),
    };
    EXPECT_EQ(std::set<Key>(keys.begin(), keys.end()).size(), keys.size());
    EXPECT_NE(key_of(Colour::kRed), key_of(Colour::kGreen));
}
