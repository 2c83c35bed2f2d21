#include "app/pipeline/memory.h"

#include <gtest/gtest.h>

#include "field/error.h"

using namespace cydonia;

TEST(Memory, GrowsWithTheCells) {
    const StageOptions stage = distance::Options{};
    EXPECT_GT(memory::of_stage(stage, 4096 * 4096, 2),
              memory::of_stage(stage, 512 * 512, 2));
    EXPECT_GT(memory::of_stage(stage, 512 * 512, 8),
              memory::of_stage(stage, 512 * 512, 2));
    EXPECT_GT(memory::of_trace(512 * 512, 1920 * 1080), memory::of_trace(512 * 512, 1));
}

TEST(Memory, RemembersNoPassesOfAPreviewAndNotAllOfALargeOne) {
    distance::Options options;
    const auto needed = [&](std::uint64_t cells) {
        return memory::of_stage(options, cells, 1);
    };
    const std::uint64_t small = needed(512 * 512), large = needed(4096 * 4096);
    options.preview = true;
    EXPECT_EQ(small - needed(512 * 512), 2 * 200 * 512 * 512u);
    EXPECT_EQ(large - needed(4096 * 4096), 2 * 268'000'000u);
}

TEST(Memory, TheMachineHasSome) {
    EXPECT_GT(memory::available(), 1'000'000u);
    EXPECT_LT(memory::available(), 1ull << 50);
}

TEST(Memory, RefusalNamesBothFigures) {
    EXPECT_NO_THROW(memory::refuse_unless_it_fits(5, 5));
    try {
        memory::refuse_unless_it_fits(2'400'000'000, 310'000'000);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kFailed);
        EXPECT_NE(std::string(error.what()).find("2.4 GB"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("310 MB"), std::string::npos);
    }
}
