#include "synth/texture/database/types.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "field/image.h"
#include "field/random.h"
#include "synth/texture/database/database.h"
#include "tests/field/temporary_folder.h"

namespace cydonia::texture {
namespace {

constexpr Rgb8 kWhite{255, 255, 255}, kRed{208, 32, 32}, kGreen{32, 160, 32},
    kBlue{32, 32, 208};
constexpr TypeSet kA = 1, kB = 2, kC = 4;

// A terrain of `cells` level-0 cells of 10 m a side, and the types a, b and c.
class Painted : public testing::Test {
  protected:
    Painted() { options_.types = {{"a", kRed}, {"b", kGreen}, {"c", kBlue}}; }

    // What colour(x, y) paints on size x size pixels.
    template <class Colour>
    Source picture(int size, const Colour& colour) {
        Field<Rgb8> image(size, size);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) image(x, y) = colour(x, y);
        write_png(folder_ / "paint.png", image);
        return open_source(folder_ / "paint.png");
    }
    template <class Colour>
    TypeMap map(int cells, int size, const Colour& colour) {
        options_.paint = picture(size, colour);
        return {options_, {10.0 * cells, 10.0 * cells, 10.0}, 8};
    }

    const TemporaryFolder folder_;
    Options options_;
};

// The whole terrain at a level of which it has `cells` a side.
Field<TypeSet> whole(const TypeMap& map, int level, int cells) {
    return map.sets({level, 0, 0, cells, cells});
}

TEST_F(Painted, QuiltOfThreeByThree) {  // figure 6
    const auto patch = [](int x, int y, int side) { return (x / side + y / side) % 3; };
    const Rgb8 colours[] = {kRed, kGreen, kBlue};
    const TypeMap types =
        map(192, 96, [&](int x, int y) { return colours[patch(x, y, 32)]; });
    const Field<TypeSet> finest = whole(types, 2, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x)
            ASSERT_EQ(finest(x, y), TypeSet{1} << patch(x, y, 16)) << x << ' ' << y;
    const Field<TypeSet> coarsest = whole(types, 7, 2);
    EXPECT_EQ(coarsest(0, 0), kA | kB | kC);
}

TEST_F(Painted, CellOnABorderMayHaveEitherType) {
    const TypeMap types = map(64, 64, [](int x, int) { return x < 30 ? kRed : kGreen; });
    const Field<TypeSet> finest = whole(types, 2, 16);
    EXPECT_EQ(finest(6, 3), kA);
    EXPECT_EQ(finest(7, 3), kA | kB);
    EXPECT_EQ(finest(8, 3), kB);
    EXPECT_EQ(whole(types, 4, 4)(1, 0), kA | kB);
}

TEST_F(Painted, NarrowBandIsNotWashedOut) {
    const TypeMap types =
        map(256, 256, [](int x, int) { return x >= 100 && x < 104 ? kBlue : kWhite; });
    for (int level = 2; level < 8; ++level)
        for (int x = 0; x < 256 >> level; ++x)
            EXPECT_EQ(types.sets({level, x, 0, 1, 1})(0, 0),
                      x == 100 >> level ? kC : kAnyType)
                << level << ' ' << x;
}

TEST_F(Painted, WindowsAreCutFromOneMap) {
    const Rgb8 colours[] = {kWhite, kRed, kGreen, kBlue};
    const TypeMap types = map(203, 77, [&](int x, int y) {
        return colours[hash_of({std::uint64_t(x / 9), std::uint64_t(y / 7)}) % 4];
    });
    for (int level = 2; level < 8; ++level) {
        const int cells = (203 >> level) + 6;
        const Window all{level, -2, -2, cells + 2, cells + 2};
        const Field<TypeSet> sets = types.sets(all);
        for (const Window& part : {Window{level, -2, 1, 3, 4}, Window{level, 1, 0, 1, 2},
                                   Window{level, cells - 2, cells - 3, 2, 3}}) {
            const Field<TypeSet> cut = types.sets(part);
            for (int y = 0; y < part.height; ++y)
                for (int x = 0; x < part.width; ++x)
                    EXPECT_EQ(cut(x, y), sets(part.x + x + 2, part.y + y + 2));
        }
    }
}

TEST_F(Painted, OutsideTheTerrainEverythingIsAllowed) {
    const TypeMap types = map(50, 20, [](int, int) { return kRed; });
    const Field<TypeSet> sets = types.sets({2, -3, -1, 20, 16});
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 20; ++x) {
            const bool inside = x >= 3 && x < 3 + 13 && y >= 1 && y < 1 + 13;
            EXPECT_EQ(sets(x, y), inside ? kA : kAnyType) << x << ' ' << y;
        }
    EXPECT_EQ(types.sets({3, 1000, 0, 2, 2})(0, 0), kAnyType);
    EXPECT_EQ(types.sets({30, 0, 0, 1, 1})(0, 0), kAnyType);
}

TEST_F(Painted, NorthWestOfThePictureIsThatOfTheTerrain) {
    const TypeMap types =
        map(64, 8, [](int x, int y) { return x < 4 && y < 4 ? kRed : kWhite; });
    const Field<TypeSet> sets = whole(types, 2, 16);
    EXPECT_EQ(sets(7, 7), kA);
    EXPECT_EQ(sets(8, 7), kAnyType);
    EXPECT_EQ(sets(7, 8), kAnyType);
}

TEST_F(Painted, DrawingInTheTypesColours) {
    options_.paint = open_source(
        folder_.with("paint.svg",
                     "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>"
                     "<rect width='50' height='100' fill='#20a020'/>"
                     "<circle cx='75' cy='50' r='12' fill='#d02020'/></svg>"));
    const TypeMap types(options_, {640, 640, 10}, 6);
    const Field<TypeSet> sets = whole(types, 2, 16);
    EXPECT_EQ(sets(2, 2), kB);
    EXPECT_EQ(sets(12, 8), kA);
    EXPECT_EQ(sets(15, 0), kAnyType);
}

TEST_F(Painted, NothingPainted) {
    const TypeMap types(options_, {640, 640, 10}, 6);
    EXPECT_TRUE(types.empty());
    EXPECT_EQ(types.sets({2, 0, 0, 3, 3})(1, 1), kAnyType);
}

TEST_F(Painted, ColourThatNoTypeHas) {
    expect_error(ExitCode::kBadRequest, "colour #808000 of paint.png has no", [&] {
        map(64, 64, [](int x, int) { return x < 32 ? kRed : Rgb8{128, 128, 0}; });
    });
}

TEST_F(Painted, TerrainOfVeryManyCells) {
    const TypeMap types =
        map(100000, 64, [](int x, int) { return x < 16 ? kRed : kWhite; });
    EXPECT_EQ(types.sets({2, 6240, 24000, 1, 1})(0, 0), kA);
    EXPECT_EQ(types.sets({2, 6260, 24000, 1, 1})(0, 0), kAnyType);
    EXPECT_EQ(types.sets({2, -1, 24000, 1, 1})(0, 0), kAnyType);
    EXPECT_EQ(types.sets({7, 190, 0, 1, 1})(0, 0), kA);
    EXPECT_EQ(types.sets({7, 200, 0, 1, 1})(0, 0), kAnyType);
}

TEST_F(Painted, TerrainOfOneCell) {
    const TypeMap types = map(1, 64, [](int, int) { return kGreen; });
    EXPECT_EQ(types.sets({2, 0, 0, 1, 1})(0, 0), kB);
}

TEST_F(Painted, ExemplarsByPictureByNameAndNotAtAll) {
    options_.exemplars.resize(3);
    options_.exemplars[0].types =
        picture(10, [](int, int y) { return y < 5 ? kBlue : kWhite; });
    options_.exemplars[1].type = options_.types[1].name;
    const Field<std::uint8_t> drawn = painted_types(options_, 0, 40, 20);
    ASSERT_EQ(drawn.width(), 40);
    EXPECT_EQ(drawn(39, 9), 2);
    EXPECT_EQ(drawn(0, 10), kNoType);
    EXPECT_EQ(painted_types(options_, 1, 7, 5), Field<std::uint8_t>(7, 5, 1));
    EXPECT_EQ(painted_types(options_, 2, 7, 5), Field<std::uint8_t>(7, 5, kNoType));
}

// Bumps of a height that rise(x / width) gives.
template <class Rise>
Field<float> bumps(int width, int height, const Rise& rise) {
    Field<float> land(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double bump = 1.5;
            for (int octave = 0; octave < 3; ++octave) {
                const double wave = 24.0 / (1 << octave);
                bump += std::sin(x / wave + 2.0 * std::sin(y / wave)) *
                        std::cos(y / wave) / (1 << octave);
            }
            land(x, y) = static_cast<float>(rise(double(x) / width) * bump);
        }
    return land;
}

// A sea in the west, hills, and mountains in the east, a third each; 30 m a cell.
Field<float> coast(int width, int height) {
    return bumps(width, height, [](double east) {
        return east < 1.0 / 3.0 ? 0.0 : east < 2.0 / 3.0 ? 60.0 : 300.0;
    });
}

double share(const Field<std::uint8_t>& types, int type, double from, double to) {
    int count = 0, all = 0;
    for (int y = 0; y < types.height(); ++y)
        for (int x = int(from * types.width()); x < int(to * types.width()); ++x, ++all)
            count += types(x, y) == type;
    return double(count) / all;
}

TEST(AutomaticTypes, SeaHillsAndMountains) {
    const std::vector<Field<float>> lands{coast(384, 200)};
    const auto types = automatic_types(lands, 30.0, 3);
    ASSERT_EQ(types.size(), 1u);
    ASSERT_TRUE(types[0].same_shape(lands[0]));
    EXPECT_GT(share(types[0], 0, 0.0, 0.32), 0.99);
    EXPECT_GT(share(types[0], 1, 0.40, 0.60), 0.95);
    EXPECT_GT(share(types[0], 2, 0.70, 1.0), 0.95);
}

Field<float> columns(const Field<float>& land, int from, int to) {
    Field<float> part(to - from, land.height());
    for (int y = 0; y < land.height(); ++y)
        std::ranges::copy(land.row(y).subspan(std::size_t(from), std::size_t(to - from)),
                          part.row(y).begin());
    return part;
}

TEST(AutomaticTypes, OneScaleForAllExemplars) {
    const Field<float> land = coast(384, 200);
    const std::vector<Field<float>> lands{columns(land, 0, 128), columns(land, 128, 256),
                                          columns(land, 256, 384)};
    const auto types = automatic_types(lands, 30.0, 3);
    for (int i = 0; i < 3; ++i)
        EXPECT_GT(share(types[std::size_t(i)], i, 0.0, 1.0), 0.95) << i;
}

TEST(AutomaticTypes, WaterIsATypeOfItsOwn) {
    const auto types = automatic_types(std::vector{coast(384, 200)}, 30.0, 2);
    EXPECT_GT(share(types[0], 0, 0.0, 0.32), 0.99);
    EXPECT_EQ(share(types[0], 0, 0.36, 1.0), 0.0);
}

TEST(AutomaticTypes, EveryTypeHasLand) {
    const std::vector lands{
        bumps(768, 400, [](double east) { return 400.0 * east * east; })};
    for (int count = 1; count <= 8; ++count) {
        const auto types = automatic_types(lands, 30.0, count);
        for (int type = 0; type < count; ++type)
            EXPECT_GT(share(types[0], type, 0.0, 1.0), 0.01) << type << " of " << count;
    }
}

TEST(AutomaticTypes, SpecklesAreNoRegion) {
    Field<float> land = coast(384, 200);
    for (int y = 96; y < 104; ++y)
        for (int x = 50; x < 58; ++x) land(x, y) = 400.0f;  // a rock in the sea
    const auto types = automatic_types(std::vector{land}, 30.0, 3);
    const auto& found = types[0];
    for (int y = 4; y < 196; ++y)
        for (int x = 4; x < 380; ++x) {
            int like = 0;
            for (int j = -4; j <= 4; j += 4)
                for (int i = -4; i <= 4; i += 4)
                    like += found(x + i, y + j) == found(x, y);
            ASSERT_GE(like, 4) << x << ' ' << y;
        }
}

TEST(AutomaticTypes, FlatLandHasTheCalmestType) {
    const std::vector<Field<float>> lands{Field<float>(33, 9, 100.0f)};
    EXPECT_EQ(automatic_types(lands, 10.0, 4)[0], Field<std::uint8_t>(33, 9, 0));
}

TEST(AutomaticTypes, OneCellAndMoreTypesThanLand) {
    const std::vector<Field<float>> lands{Field<float>(1, 1, 3.0f),
                                          Field<float>(5, 2, 3.0f)};
    const auto types = automatic_types(lands, 10.0, 32);
    EXPECT_EQ(types[1].width(), 5);
    EXPECT_TRUE(automatic_types({}, 10.0, 3).empty());
}

TEST(AutomaticTypes, SameForAnyNumberOfThreads) {
    const std::vector<Field<float>> lands{coast(300, 200)};
    const auto with_threads = [&](std::size_t threads) {
        tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return automatic_types(lands, 30.0, 4);
    };
    EXPECT_EQ(with_threads(1), with_threads(8));
}

}  // namespace
}  // namespace cydonia::texture
