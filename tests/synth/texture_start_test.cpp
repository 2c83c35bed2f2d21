#include "synth/texture/synthesis/start.h"

#include <gtest/gtest.h>

#include "field/files.h"
#include "synth/texture/synthesis/origins.h"
#include "tests/synth/texture_lands.h"

namespace cydonia::texture {
namespace {

class Start : public testing::Test {
  protected:
    Start() {
        Options options;
        options.levels = 3;
        options.exemplars = {exemplar_of(files_, "a.tif", rough(176, 176), 30.0)};
        SilentProgress silent;
        database_ = database_of(options, {}, silent);
        top_ = int(database_->levels.size()) - 1;
        layout_ = start_of(*database_, {.seed = 5});
    }
    Synthesis land(int x, int y, int width, int height) const {
        return started(*database_, layout_, {}, {top_, x, y, width, height});
    }

    TemporaryFolder files_;
    std::shared_ptr<const Database> database_;
    int top_ = 0;
    Layout layout_;
};

TEST_F(Start, AnyWindowIsThePlanes) {
    const Synthesis whole = land(-40, -30, 120, 90), part = land(-17, 8, 30, 20);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 30; ++x)
            ASSERT_EQ(part.origins(x, y), whole.origins(x + 23, y + 38));
}

TEST_F(Start, SeamsAreThePlanesToo) {
    const auto cut = [&](int x, int y, int width, int height) {
        Synthesis land{
            {layout_.level, x, y, width, height}, {width, height}, {width, height}};
        cut_out(land, *database_, layout_, {});
        return land;
    };
    const Synthesis whole = cut(-40, -30, 120, 90), part = cut(-17, 8, 30, 20);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 30; ++x)
            ASSERT_EQ(part.origins(x, y), whole.origins(x + 23, y + 38));
}

TEST_F(Start, LandOfAskedTypesIsNotCut) {
    Synthesis land{{layout_.level, 0, 0, 8, 8}, {8, 8}, {8, 8}};
    Field<TypeSet> types(8, 8, kAnyType);
    types(3, 4) = 1;
    cut_out(land, *database_, layout_, types);
    EXPECT_EQ(land.origins(3, 4), Origin{});
    EXPECT_NE(land.origins(4, 3), Origin{});
}

}  // namespace
}  // namespace cydonia::texture
