#include "app/console.h"

#include <gtest/gtest.h>

using namespace cydonia;

TEST(Console, Durations) {
    EXPECT_EQ(duration_text(0.4251), "0.43 s");
    EXPECT_EQ(duration_text(9.999), "10 s");
    EXPECT_EQ(duration_text(59.7), "1 min 00 s");
    EXPECT_EQ(duration_text(72.0), "1 min 12 s");
    EXPECT_EQ(duration_text(11100.0), "3 h 05 min");
}

TEST(Console, QuietSaysNothing) {
    ::testing::internal::CaptureStderr();
    {
        Console console(Console::Style::kQuiet);
        console.step("a");
        console.report(0.5);
        console.note("b");
        console.warn("c");
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(Console, LinesForALog) {
    ::testing::internal::CaptureStderr();
    {
        Console console(Console::Style::kLines);
        console.step("short");
        console.report(0.5);
        console.note("a note");
        console.warn("a warning");
    }
    const std::string text = ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(text, "  a note\n  warning: a warning\n");
}

TEST(Console, BarOnATerminal) {
    ::testing::internal::CaptureStderr();
    {
        Console console(Console::Style::kBar);
        console.step("trace overhead");
        console.report(0.25);
    }
    const std::string text = ::testing::internal::GetCapturedStderr();
    EXPECT_NE(text.find("trace overhead"), std::string::npos);
    EXPECT_NE(text.find("[####............]  25%"), std::string::npos);
}
