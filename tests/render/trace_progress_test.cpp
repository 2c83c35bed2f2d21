// What POV-Ray printed over a trace, and when, against what was made of it. The seconds
// are the processor's: others used the machine too.
#include "render/frames/trace_progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace cydonia::render {
namespace {

constexpr const char* kFromTheSide =
    "radiosity {\n count 160, 4000 pretrace_start 0.08 pretrace_end 0.004 }\n";
constexpr const char* kFromAbove =
    "radiosity {\n pretrace_end 0.004 }\n camera {\n    orthographic\n";

struct Moment {
    double seconds, fraction;
};

struct Recording {
    std::vector<Moment> moments;
    double seconds = 0.0;  // of all
};

Recording heard(const std::string& name, const char* pov) {
    std::ifstream in(std::string(CYDONIA_SOURCE_DIR) + "/tests/golden/povray/" + name);
    TraceProgress progress(pov);
    Recording recording;
    for (std::string line; std::getline(in, line);) {
        const auto tab = line.find('\t');
        recording.seconds = std::stod(line.substr(0, tab));
        progress.hear(line.substr(tab + 1), recording.seconds);
        recording.moments.push_back({recording.seconds, progress.fraction()});
    }
    return recording;
}

void expect_in_time(const Recording& recording) {
    ASSERT_GT(recording.moments.size(), 100u);
    double before = 0.0;
    for (const auto& [seconds, fraction] : recording.moments) {
        const double true_fraction = seconds / recording.seconds;
        EXPECT_GE(fraction, before) << seconds;
        EXPECT_LT(fraction, 1.0) << seconds;
        before = fraction;
        if (true_fraction < 0.1) continue;
        EXPECT_NEAR(fraction, true_fraction, 0.06) << seconds;
        if (true_fraction > 0.85) continue;  // seconds are left
        const double left = seconds * (1.0 - fraction) / fraction;
        EXPECT_NEAR(left / (recording.seconds - seconds), 1.0, 0.2) << seconds;
    }
}

TEST(TraceProgress, TimeLeftHoldsFromATenthOn) {
    expect_in_time(heard("oblique_final_960.txt", kFromTheSide));
}

TEST(TraceProgress, TimeLeftHoldsFromAboveToo) {
    expect_in_time(heard("overhead_final_360.txt", kFromAbove));
}

TEST(TraceProgress, IsNotDoneWhenTheLightIsGathered) {
    TraceProgress progress(kFromTheSide);
    for (int i = 1; i <= 100; ++i)
        progress.hear("Rendered " + std::to_string(i) + " of 100 pixels", 0.1 * i);
    EXPECT_LT(progress.fraction(), 0.9);
    EXPECT_GT(progress.fraction(), 0.1);
}

TEST(TraceProgress, WithoutRadiosityIsTheShareOfPixels) {
    TraceProgress progress("global_settings { }");
    EXPECT_TRUE(progress.hear("Rendered 25 of 100 pixels (25%)", 1.0));
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.25);
    EXPECT_TRUE(progress.hear("Rendered 20 of 100 pixels (20%)", 2.0));
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.25);
    EXPECT_FALSE(progress.hear("Parse Error: Rendered 1 of 2", 3.0));
    EXPECT_FALSE(progress.hear("Rendered", 3.0));
    EXPECT_FALSE(progress.hear("Rendered 1 of 0 pixels", 3.0));
}

}  // namespace
}  // namespace cydonia::render
