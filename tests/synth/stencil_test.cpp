#include "synth/pareidolia/stencil.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "field/image.h"
#include "field/random.h"

namespace cydonia::pareidolia {
namespace {

// A face as a camera might see it: lit from the left, the light uneven, grain over all.
// Coordinates from -1 to 1, y down.
double face_at(double x, double y) {
    const auto disc = [&](double cx, double cy, double rx, double ry) {
        const double u = (x - cx) / rx, v = (y - cy) / ry;
        return u * u + v * v < 1.0;
    };
    const double light = 0.15 * -x + 0.08 * y;
    if (disc(-0.25, -0.1, 0.09, 0.05) || disc(0.25, -0.1, 0.09, 0.05)) return 0.15;
    if (disc(0.0, 0.4, 0.25, 0.05)) return 0.3;
    if (disc(0.0, 0.05, 0.6, 0.75) && y > -0.35) return 0.68 + light;      // skin
    if (disc(0.0, -0.1, 0.72, 0.8) && y < 0.3) return 0.12 + 0.3 * light;  // hair
    if (disc(0.0, 1.3, 0.9, 0.6)) return 0.2;                              // coat
    return 0.78 + light;
}

Field<float> photograph(int side) {
    Field<float> image(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const auto grain = hash_of({std::uint64_t(x), std::uint64_t(y), 7u}) >> 40;
            image(x, y) = static_cast<float>(
                face_at(2.0 * (x + 0.5) / side - 1.0, 2.0 * (y + 0.5) / side - 1.0) +
                0.06 * (double(grain) / (1 << 24) - 0.5));
        }
    return image;
}

bool ink_at(const Field<float>& drawing, double x, double y) {
    const auto cell = [&](double at, int size) {
        return std::clamp(int(0.5 * (at + 1.0) * size), 0, size - 1);
    };
    return drawing(cell(x, drawing.width()), cell(y, drawing.height())) < 0.5f;
}

double ink_share(const Field<float>& drawing) {
    return double(std::count_if(drawing.begin(), drawing.end(),
                                [](float l) { return l < 0.5f; })) /
           double(drawing.size());
}

// Connected areas of ink, and of paper.
std::array<int, 2> areas_of(const Field<float>& drawing) {
    std::array<int, 2> counts{};
    for (int tone = 0; tone < 2; ++tone) {
        cv::Mat mask(drawing.height(), drawing.width(), CV_8U), labels;
        for (int y = 0; y < drawing.height(); ++y)
            for (int x = 0; x < drawing.width(); ++x)
                mask.at<unsigned char>(y, x) = (drawing(x, y) < 0.5f) == (tone == 0);
        counts[std::size_t(tone)] = cv::connectedComponents(mask, labels) - 1;
    }
    return counts;
}

TEST(Stencil, KeepsWhatMakesAFace) {
    const Field<float> drawing = stencil(photograph(300), 0.5);
    EXPECT_TRUE(ink_at(drawing, -0.25, -0.1));  // eyes
    EXPECT_TRUE(ink_at(drawing, 0.25, -0.1));
    EXPECT_TRUE(ink_at(drawing, 0.0, 0.4));   // mouth
    EXPECT_TRUE(ink_at(drawing, 0.0, -0.6));  // hair
    EXPECT_TRUE(ink_at(drawing, 0.0, 0.95));  // coat
    EXPECT_FALSE(ink_at(drawing, 0.0, 0.1));  // skin, on the light side and the dark
    EXPECT_FALSE(ink_at(drawing, 0.4, 0.15));
    EXPECT_FALSE(ink_at(drawing, -0.4, 0.15));
    EXPECT_FALSE(ink_at(drawing, 0.95, 0.0));  // the ground behind
    EXPECT_FALSE(ink_at(drawing, -0.95, -0.9));
}

TEST(Stencil, FrecklesGoAndEyesStay) {
    Field<float> image = photograph(768);
    for (const auto& [x, y] : {std::pair{330, 430}, {440, 450}, {384, 300}})
        for (int j = -5; j <= 5; ++j)
            for (int i = -5; i <= 5; ++i)
                if (i * i + j * j <= 25) image(x + i, y + j) = 0.1f;
    const Field<float> drawing = stencil(image, 0.5);
    for (const auto& [x, y] : {std::pair{330, 430}, {440, 450}, {384, 300}})
        EXPECT_GT(drawing(x, y), 0.5f) << x << ", " << y;
    EXPECT_TRUE(ink_at(drawing, 0.25, -0.1));
}

TEST(Stencil, LightFromOneSide) {
    Field<float> image = photograph(300);
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 300; ++x) image(x, y) *= 1.0f - 0.6f * float(x) / 300.0f;
    const Field<float> drawing = stencil(image, 0.5);
    EXPECT_FALSE(ink_at(drawing, 0.4, 0.15));  // skin in the half dark
    EXPECT_TRUE(ink_at(drawing, 0.25, -0.1));
    EXPECT_TRUE(ink_at(drawing, -0.25, -0.1));
    EXPECT_FALSE(ink_at(drawing, 0.8, 0.0));  // the ground behind it
}

// A pale disc on paler ground, beside something dark.
TEST(Stencil, FaintContoursAreLines) {
    Field<float> image(400, 400, 0.85f);
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 400; ++x)
            if (std::hypot(x - 150, y - 200) < 90.0)
                image(x, y) = 0.6f;
            else if (x > 320)
                image(x, y) = 0.1f;
    const Field<float> drawing = stencil(image, 0.5);
    bool line = false;
    for (int x = 90; x < 140; ++x) line |= drawing(x, drawing.height() / 2) < 0.5f;
    EXPECT_TRUE(line);
    EXPECT_FALSE(ink_at(drawing, -0.25, 0.0));
    EXPECT_TRUE(ink_at(drawing, 0.8, 0.0));
}

TEST(Stencil, GrainLeavesNoSpecks) {
    const auto [ink, paper] = areas_of(stencil(photograph(300), 0.5));
    EXPECT_LE(ink, 8);  // hair, eyes, mouth, coat, and lines
    EXPECT_LE(paper, 8);
}

TEST(Stencil, SizeOfThePhotographMattersLittle) {
    const Field<float> small = stencil(photograph(200), 0.5),
                       large = stencil(photograph(1200), 0.5);
    ASSERT_TRUE(small.same_shape(large));
    int differ = 0;
    for (std::size_t i = 0; i < small.size(); ++i)
        differ += (small[i] < 0.5f) != (large[i] < 0.5f);
    EXPECT_LT(differ, 0.02 * double(small.size()));
}

TEST(Stencil, MoreDarknessIsMoreInk) {
    const Field<float> image = photograph(300);
    EXPECT_LT(ink_share(stencil(image, 0.3)), ink_share(stencil(image, 0.5)));
    EXPECT_LT(ink_share(stencil(image, 0.5)), ink_share(stencil(image, 0.7)));
}

TEST(Stencil, BrightnessAndContrastDoNotMatter) {
    Field<float> image = photograph(300);
    const Field<float> plain = stencil(image, 0.5);
    for (float& l : image) l = 0.2f + 0.4f * l;
    EXPECT_NEAR(ink_share(stencil(image, 0.5)), ink_share(plain), 0.01);
}

TEST(Stencil, OddShapes) {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 500}, {900, 2}}) {
        const Field<float> drawing = stencil(Field<float>(width, height, 0.4f), 0.5);
        EXPECT_EQ(std::max(drawing.width(), drawing.height()), kStencilSide);
        for (const float l : drawing) ASSERT_TRUE(l >= 0.0f && l <= 1.0f);
    }
}

}  // namespace
}  // namespace cydonia::pareidolia
