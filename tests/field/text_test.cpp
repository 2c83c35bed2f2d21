#include <gtest/gtest.h>

#include <string>

#include "field/base64.h"
#include "field/utf8.h"

namespace cydonia {
namespace {

using Characters = std::vector<char32_t>;

TEST(Utf8, CharactersOfEveryLength) {
    EXPECT_EQ(characters_of(""), Characters{});
    EXPECT_EQ(characters_of("a\u00e9\u5c71\U0001f3d4"),
              (Characters{'a', 0xe9, 0x5c71, 0x1f3d4}));
    EXPECT_EQ(characters_of(std::string_view("a\0b", 3)), (Characters{'a', 0, 'b'}));
    EXPECT_EQ(characters_of("\xed\x9f\xbf\xee\x80\x80\xf4\x8f\xbf\xbf"),
              (Characters{0xd7ff, 0xe000, 0x10ffff}));
}

// Unicode 15, table 3-7.
TEST(Utf8, WhatIsNotWellFormed) {
    for (const char* bad : {"\x80",
                            "\xbf",
                            "\xc0\x80",
                            "\xc1\xbf",  // no beginning
                            "\xe0\x80\x80",
                            "\xe0\x9f\xbf",
                            "\xf0\x80\x80\x80",  // overlong
                            "\xf0\x8f\xbf\xbf",
                            "\xed\xa0\x80",
                            "\xed\xbf\xbf",  // surrogates
                            "\xf4\x90\x80\x80",
                            "\xf5\x80\x80\x80",
                            "\xfe",
                            "\xff",  // too high
                            "\xc3",
                            "\xe5\xb1",
                            "\xf0\x9f\x8f",
                            "\xc3(",
                            "\xe5(\xb1",  // cut short
                            "\xe5\xb1(",
                            "\xf0\x9f\x8f(",
                            "\xf8\x88\x80\x80\x80"}) {
        EXPECT_FALSE(characters_of(bad)) << bad;
        EXPECT_FALSE(characters_of("before " + std::string(bad) + " after")) << bad;
    }
    EXPECT_FALSE(characters_of(std::string_view("\xc3\0", 2)));
    EXPECT_FALSE(characters_of(std::string_view("\xc3\xa9", 1)));
}

// RFC 4648, section 10.
TEST(Base64, Vectors) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string_view("\xff\xfe\0", 3)), "//4A");
    EXPECT_EQ(base64(std::string(300, '\0')), std::string(400, 'A'));
}

}  // namespace
}  // namespace cydonia
