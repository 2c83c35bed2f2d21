#include "synth/texture/synthesis/patches.h"

#include <gtest/gtest.h>

#include "synth/texture/synthesis/origins.h"

using namespace cydonia;
using namespace cydonia::texture;

namespace {

// Square exemplars, of which only the size is known.
class Sheets : public Database {
  public:
    explicit Sheets(int count, int side = 32)
        : sheets_(static_cast<std::size_t>(count), {side, side, side, 0}) {
        levels.resize(1);
        levels[0].sheets = sheets_;
    }

  private:
    std::vector<Sheet> sheets_;
};

Origin place(int exemplar, int orientation, int x, int y) {
    return origin_of({exemplar, orientation, 2 * x + 1, 2 * y + 1});
}

// One piece of an exemplar: `corner` is what lies in the field's north-west.
void lay(Field<Origin>& origins, int x0, int x1, Step corner, int exemplar = 0,
         int orientation = 0) {
    for (int y = 0; y < origins.height(); ++y)
        for (int x = x0; x < x1; ++x) {
            const Step s = turned(orientation, {x, y});
            origins(x, y) = place(exemplar, orientation, corner.x + s.x, corner.y + s.y);
        }
}

TEST(Patches, ACopyIsOnePatch) {
    Field<Origin> origins(12, 10);
    lay(origins, 0, 12, {3, 4});
    const PatchFigures figures = patch_figures(Sheets(1), origins);
    EXPECT_EQ(figures.coherent, 1.0);
    EXPECT_EQ(figures.patches, 1);
    EXPECT_EQ(figures.typical, 120);
    EXPECT_EQ(figures.largest, 120);
}

TEST(Patches, ATurnedAndMirroredCopyIsOnePatch) {
    for (int orientation = 0; orientation < 8; ++orientation) {
        Field<Origin> origins(9, 9);
        lay(origins, 0, 9, {16, 16}, 0, orientation);
        EXPECT_EQ(patch_figures(Sheets(1), origins).coherent, 1.0) << orientation;
        EXPECT_EQ(patch_figures(Sheets(1), origins).patches, 1) << orientation;
    }
}

TEST(Patches, ASeamEndsThem) {
    Field<Origin> origins(12, 10);
    lay(origins, 0, 4, {0, 0});
    lay(origins, 4, 12, {1, 0});  // one cell further
    const PatchFigures figures = patch_figures(Sheets(1), origins);
    EXPECT_EQ(figures.patches, 2);
    EXPECT_EQ(figures.typical, 80);
    EXPECT_EQ(figures.largest, 80);
    EXPECT_DOUBLE_EQ(figures.coherent, 10.0 / 12.0);  // not the columns on both sides
}

TEST(Patches, AnotherExemplarOrAnotherWayToLayItIsASeam) {
    Field<Origin> origins(8, 8);
    lay(origins, 0, 4, {0, 0}, 0);
    lay(origins, 4, 8, {0, 0}, 1);
    EXPECT_EQ(patch_figures(Sheets(2), origins).patches, 2);
    lay(origins, 4, 8, {8, 0}, 0, 4);  // begins where the other ends, and runs back
    EXPECT_EQ(patch_figures(Sheets(2), origins).patches, 2);
}

TEST(Patches, HalfTheLandIsInPatchesOfTheTypicalSize) {
    Field<Origin> origins(10, 1);
    lay(origins, 0, 10, {0, 0});
    for (int x : {0, 2, 4}) origins(x, 0) = place(0, 0, 20, 20 + x);
    // Sizes 5, 1, 1, 1, 1, 1.
    EXPECT_EQ(patch_figures(Sheets(1), origins).patches, 6);
    EXPECT_EQ(patch_figures(Sheets(1), origins).typical, 5);
    origins(8, 0) = place(0, 0, 20, 29);
    EXPECT_EQ(patch_figures(Sheets(1), origins).typical, 1);  // 3, then seven times 1
}

TEST(Patches, BlocksThatAnyCellIsFromAreUsed) {
    Field<Origin> origins(2, 1, place(0, 0, 0, 0));
    EXPECT_DOUBLE_EQ(patch_figures(Sheets(1), origins).used, 0.25);
    origins(1, 0) = place(0, 0, 31, 31);
    EXPECT_DOUBLE_EQ(patch_figures(Sheets(1), origins).used, 0.5);
    origins(1, 0) = place(1, 0, 16, 15);
    EXPECT_DOUBLE_EQ(patch_figures(Sheets(2), origins).used, 0.25);
}

TEST(Patches, BlocksThatAnExemplarEndsWithinDoNotCount) {
    Field<Origin> origins(2, 1, place(0, 0, 0, 0));
    origins(1, 0) = place(0, 0, 36, 20);
    EXPECT_DOUBLE_EQ(patch_figures(Sheets(1, 40), origins).used, 0.25);
}

TEST(Patches, CellsOfACoarserLevelAreWider) {
    Field<Origin> origins(12, 10);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 12; ++x)
            origins(x, y) = origin_of({0, 0, 8 * x + 4, 8 * y + 4});
    Sheets coarse(1);
    coarse.levels.resize(3, coarse.levels[0]);
    EXPECT_EQ(patch_figures(coarse, origins, 2).patches, 1);
    EXPECT_EQ(patch_figures(coarse, origins, 2).used,
              0.25);  // of the 32 x 32 cells there
    EXPECT_EQ(patch_figures(coarse, origins, 0).patches, 120);
    EXPECT_EQ(source_map(coarse, origins, 2)(11, 0)[0], 255 * 11 / 31);
}

TEST(Patches, NoCellsAtAll) {
    EXPECT_EQ(patch_figures(Sheets(1), {}).patches, 0);
    EXPECT_TRUE(source_map(Sheets(1), {}).empty());
}

TEST(Patches, MapOfSources) {
    Field<Origin> origins(3, 1, place(0, 0, 0, 0));
    origins(1, 0) = place(1, 5, 31, 0);
    origins(2, 0) = place(2, 0, 0, 31);
    const Field<Rgb8> map = source_map(Sheets(3), origins);
    EXPECT_EQ(map(0, 0), (Rgb8{0, 0, 0}));
    EXPECT_EQ(map(1, 0), (Rgb8{255, 0, 128}));
    EXPECT_EQ(map(2, 0), (Rgb8{0, 255, 255}));
}

}  // namespace
