#include "field/file_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

namespace cydonia {
namespace {

std::string in_small_letters(std::string text) {
    for (char& c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

const std::vector<std::string> kAdversarial = {"",
                                               "a",
                                               "A",
                                               "a b",
                                               "a-b",
                                               "a_b",
                                               "a.b",
                                               "a/b",
                                               "..",
                                               ".",
                                               "a\nb",
                                               "a\\b",
                                               "Sea floor",
                                               "sea floor",
                                               "sea-floor",
                                               "海底",
                                               "山地",
                                               "沙滩",
                                               "---",
                                               "------",
                                               "é",
                                               "É",
                                               "e\xcc\x81",
                                               "\xff",
                                               "\xfe",
                                               "a~b",
                                               "type-é",
                                               std::string("a\0b", 3),
                                               std::string(300, 'x'),
                                               std::string(301, 'x'),
                                               std::string(64, 'x'),
                                               std::string(65, 'x')};

TEST(FileNames, NoTwoTextsHaveOneNameOnAnyDisk) {
    std::set<std::string> names;
    for (const std::string& text : kAdversarial)
        EXPECT_TRUE(names.insert(in_small_letters(file_name_of(text))).second)
            << text << " is " << file_name_of(text);
    // A text that is another's name has a third.
    for (const std::string& text : kAdversarial) {
        const std::string name = file_name_of(text);
        if (name == text) continue;
        EXPECT_TRUE(names.insert(in_small_letters(file_name_of(name))).second);
    }
}

TEST(FileNames, AreSafeAndOfBoundedLength) {
    for (const std::string& text : kAdversarial) {
        const std::string name = file_name_of(text);
        EXPECT_LE(name.size(), 64u);
        EXPECT_FALSE(name.empty());
        EXPECT_EQ(name.find_first_of(std::string("/\\.\n\0 ", 6)), name.npos) << name;
    }
}

TEST(FileNames, StayReadable) {
    EXPECT_EQ(file_name_of("type-walls"), "type-walls");
    EXPECT_TRUE(file_name_of("海底").starts_with("海底~"));
    EXPECT_TRUE(file_name_of("Sea floor").starts_with("Sea-floor~"));
    const std::string cut =
        file_name_of("x" + std::string(20, '-') + "海海海海海海海海海海海海");
    EXPECT_NE(cut.find("海~"), cut.npos);  // between two characters
}

TEST(FileNames, SideBySideNeedNoHashUnlessTheyClash) {
    EXPECT_EQ(file_names_of({"sea floor", "Plain", "beach"}),
              (std::vector<std::string>{"sea-floor", "Plain", "beach"}));
    const auto clashing =
        file_names_of({"sea floor", "sea-floor", "rock", "Rock", "海底"});
    std::set<std::string> different;
    for (const std::string& name : clashing) different.insert(in_small_letters(name));
    EXPECT_EQ(different.size(), clashing.size());
    EXPECT_EQ(file_names_of({"海底", "山地", "沙滩"})[1], file_name_of("山地"));
}

}  // namespace
}  // namespace cydonia
