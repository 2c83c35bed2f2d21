#include "synth/texture/synthesis/patches.h"

#include <gtest/gtest.h>

#include "synth/texture/synthesis/places.h"

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

Place place(int exemplar, int orientation, int x, int y) {
    return place_of({exemplar, orientation, 2 * x + 1, 2 * y + 1});
}

// One piece of an exemplar: `corner` is what lies in the field's north-west.
void lay(Field<Place>& places, int x0, int x1, Step corner, int exemplar = 0,
         int orientation = 0) {
    for (int y = 0; y < places.height(); ++y)
        for (int x = x0; x < x1; ++x) {
            const Step s = turned(orientation, {x, y});
            places(x, y) = place(exemplar, orientation, corner.x + s.x, corner.y + s.y);
        }
}

TEST(Patches, ACopyIsOnePatch) {
    Field<Place> places(12, 10);
    lay(places, 0, 12, {3, 4});
    const PatchFigures figures = patch_figures(Sheets(1), places);
    EXPECT_EQ(figures.coherent, 1.0);
    EXPECT_EQ(figures.patches, 1);
    EXPECT_EQ(figures.typical, 120);
    EXPECT_EQ(figures.largest, 120);
}

TEST(Patches, ATurnedAndMirroredCopyIsOnePatch) {
    for (int orientation = 0; orientation < 8; ++orientation) {
        Field<Place> places(9, 9);
        lay(places, 0, 9, {16, 16}, 0, orientation);
        EXPECT_EQ(patch_figures(Sheets(1), places).coherent, 1.0) << orientation;
        EXPECT_EQ(patch_figures(Sheets(1), places).patches, 1) << orientation;
    }
}

TEST(Patches, ASeamEndsThem) {
    Field<Place> places(12, 10);
    lay(places, 0, 4, {0, 0});
    lay(places, 4, 12, {1, 0});  // one cell further
    const PatchFigures figures = patch_figures(Sheets(1), places);
    EXPECT_EQ(figures.patches, 2);
    EXPECT_EQ(figures.typical, 80);
    EXPECT_EQ(figures.largest, 80);
    EXPECT_DOUBLE_EQ(figures.coherent, 10.0 / 12.0);  // not the columns on both sides
}

TEST(Patches, AnotherExemplarOrAnotherWayToLayItIsASeam) {
    Field<Place> places(8, 8);
    lay(places, 0, 4, {0, 0}, 0);
    lay(places, 4, 8, {0, 0}, 1);
    EXPECT_EQ(patch_figures(Sheets(2), places).patches, 2);
    lay(places, 4, 8, {8, 0}, 0, 4);  // begins where the other ends, and runs back
    EXPECT_EQ(patch_figures(Sheets(2), places).patches, 2);
}

TEST(Patches, HalfTheLandIsInPatchesOfTheTypicalSize) {
    Field<Place> places(10, 1);
    lay(places, 0, 10, {0, 0});
    for (int x : {0, 2, 4}) places(x, 0) = place(0, 0, 20, 20 + x);
    // Sizes 5, 1, 1, 1, 1, 1.
    EXPECT_EQ(patch_figures(Sheets(1), places).patches, 6);
    EXPECT_EQ(patch_figures(Sheets(1), places).typical, 5);
    places(8, 0) = place(0, 0, 20, 29);
    EXPECT_EQ(patch_figures(Sheets(1), places).typical, 1);  // 3, then seven times 1
}

TEST(Patches, BlocksThatAnyCellIsFromAreUsed) {
    Field<Place> places(2, 1, place(0, 0, 0, 0));
    EXPECT_DOUBLE_EQ(patch_figures(Sheets(1), places).used, 0.25);
    places(1, 0) = place(0, 0, 31, 31);
    EXPECT_DOUBLE_EQ(patch_figures(Sheets(1), places).used, 0.5);
    places(1, 0) = place(1, 0, 16, 15);
    EXPECT_DOUBLE_EQ(patch_figures(Sheets(2), places).used, 0.25);
}

TEST(Patches, BlocksThatAnExemplarEndsWithinDoNotCount) {
    Field<Place> places(2, 1, place(0, 0, 0, 0));
    places(1, 0) = place(0, 0, 36, 20);
    EXPECT_DOUBLE_EQ(patch_figures(Sheets(1, 40), places).used, 0.25);
}

TEST(Patches, CellsOfACoarserLevelAreWider) {
    Field<Place> places(12, 10);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 12; ++x)
            places(x, y) = place_of({0, 0, 8 * x + 4, 8 * y + 4});
    Sheets coarse(1);
    coarse.levels.resize(3, coarse.levels[0]);
    EXPECT_EQ(patch_figures(coarse, places, 2).patches, 1);
    EXPECT_EQ(patch_figures(coarse, places, 2).used, 0.25);  // of the 32 x 32 cells there
    EXPECT_EQ(patch_figures(coarse, places, 0).patches, 120);
    EXPECT_EQ(source_map(coarse, places, 2)(11, 0)[0], 255 * 11 / 31);
}

TEST(Patches, NoCellsAtAll) {
    EXPECT_EQ(patch_figures(Sheets(1), {}).patches, 0);
    EXPECT_TRUE(source_map(Sheets(1), {}).empty());
}

TEST(Patches, MapOfSources) {
    Field<Place> places(3, 1, place(0, 0, 0, 0));
    places(1, 0) = place(1, 5, 31, 0);
    places(2, 0) = place(2, 0, 0, 31);
    const Field<Rgb8> map = source_map(Sheets(3), places);
    EXPECT_EQ(map(0, 0), (Rgb8{0, 0, 0}));
    EXPECT_EQ(map(1, 0), (Rgb8{255, 0, 128}));
    EXPECT_EQ(map(2, 0), (Rgb8{0, 255, 255}));
}

}  // namespace
