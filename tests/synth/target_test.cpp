#include "synth/pareidolia/target.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "field/strokes.h"
#include "field/vec.h"
#include "tests/synth/target_files.h"

namespace cydonia::pareidolia {
namespace {

using Mask = Field<std::uint8_t>;

class Target : public TargetFiles {
  protected:
    Mask target(const ImageOptions& options, int width = 100, int height = 100) {
        told_ = {};
        return shadow_target(options, width, height, told_);
    }
    std::string refused(const ImageOptions& options, int width = 100, int height = 100) {
        return refusal([&] { target(options, width, height); });
    }
    Told told_;
};
using Text = Target;

// 1 in a rectangle of cells.
Mask box(int width, int height, int x0, int y0, int x1, int y1) {
    Mask mask(width, height);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) mask(x, y) = 1;
    return mask;
}

double area(const Mask& mask) {
    return double(std::count(mask.begin(), mask.end(), std::uint8_t{1}));
}

double iou(const Mask& a, const Mask& b) {
    double both = 0.0, any = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += a[i] && b[i];
        any += a[i] || b[i];
    }
    return both / any;
}

Mask turned_clockwise(const Mask& mask) {
    Mask result(mask.height(), mask.width());
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            result(mask.height() - 1 - y, x) = mask(x, y);
    return result;
}

// An upright L, its foot in the south-east.
constexpr const char* kL =
    "<path d='M 30,10 v 80 h 50 v -20 h -30 v -60 z' fill='black'/>";

TEST_F(Target, SquareOnSquareIsResizedAndNoMore) {
    const Source drawing = svg("l.svg", 100, 100, kL);
    Field<std::uint8_t> grey(77, 77);
    for (std::size_t i = 0; i < grey.size(); ++i)
        grey[i] = static_cast<std::uint8_t>(i * 7919 % 251);
    for (const Source& source : {drawing, png("noise.png", grey)})
        for (const int side : {40, 77, 100, 300}) {
            const Field<float> resized = read_grey_at(source, side, side);
            Mask dark(side, side);
            std::transform(resized.begin(), resized.end(), dark.begin(),
                           [](float g) { return g < 0.5f; });
            EXPECT_EQ(target({.target = source}, side, side), dark) << side;
        }
}

TEST_F(Target, KeepsItsProportions) {
    const Source wide = png("wide.png", grey_box(200, 100, 20, 20, 180, 80));
    EXPECT_EQ(target({.target = wide}), box(100, 100, 10, 35, 90, 65));
    EXPECT_EQ(target({.target = wide}, 300, 100), box(300, 100, 70, 20, 230, 80));
    EXPECT_EQ(target({.target = wide}, 100, 50), box(100, 50, 10, 10, 90, 40));
    EXPECT_EQ(told_.notes, "wide.png: 200x100 pixels on 100x50 cells\n");
}

TEST_F(Target, PositionIsCountedFromTheSouthWest) {
    ImageOptions options{.target = png("a.png", grey_box(100, 100, 40, 40, 60, 60))};
    options.placing.position = {0.25, 0.8};
    EXPECT_EQ(target(options), box(100, 100, 15, 10, 35, 30));
    EXPECT_EQ(target(options, 200, 100), box(200, 100, 40, 10, 60, 30));
}

TEST_F(Target, ScaleIsOfTheSide) {
    ImageOptions options{.target = png("a.png", grey_box(100, 100, 20, 40, 80, 60))};
    options.placing.scale = 0.5;
    EXPECT_EQ(target(options), box(100, 100, 35, 45, 65, 55));
    options.placing.scale = 1.5;
    EXPECT_EQ(target(options), box(100, 100, 5, 35, 95, 65));
}

TEST_F(Target, RotationIsClockwise) {
    ImageOptions options{.target = svg("l.svg", 100, 100, kL)};
    const Mask upright = target(options);
    options.placing.rotation = radians(90.0);
    EXPECT_EQ(target(options), turned_clockwise(upright));
    options.placing.rotation = radians(-270.0);
    EXPECT_EQ(target(options), turned_clockwise(upright));
    options.placing.rotation = radians(33.0);
    EXPECT_NEAR(area(target(options)), area(upright), 0.02 * area(upright));
    EXPECT_NE(target(options), upright);
}

TEST_F(Target, SmallScalesAverage) {
    // Stripes a pixel wide, three of four black, then one of four: all and nothing.
    for (const int black : {3, 1}) {
        Field<std::uint8_t> grey = grey_box(400, 400, 0, 0, 0, 0);
        for (int y = 100; y < 300; ++y)
            for (int x = 100; x < 300; ++x) grey(x, y) = x % 4 < black ? 0 : 255;
        ImageOptions options{.target = png("stripes.png", grey)};
        options.placing = {.position = {0.503, 0.491}, .scale = 0.3, .rotation = 0.2};
        if (black == 3)
            EXPECT_NEAR(area(target(options)), 15.0 * 15.0, 10.0);
        else
            EXPECT_TRUE(contains(refused(options), "thinner than a cell"))
                << refused(options);
    }
}

TEST_F(Target, GroundBeyondThePictureIsLit) {
    ImageOptions options{.target = png("a.png", grey_box(100, 100, 40, 40, 60, 60, 0))};
    options.invert = true;
    options.placing.scale = 0.5;
    Mask ring = box(100, 100, 25, 25, 75, 75);
    for (int y = 45; y < 55; ++y)
        for (int x = 45; x < 55; ++x) ring(x, y) = 0;
    EXPECT_EQ(target(options), ring);
}

TEST_F(Target, ThresholdTellsDarkFromLight) {
    Field<std::uint8_t> ramp(256, 256, 255);
    for (int y = 20; y < 236; ++y)
        for (int x = 0; x < 256; ++x) ramp(x, y) = static_cast<std::uint8_t>(x);
    ImageOptions options{.target = png("ramp.png", ramp)};
    for (const double threshold : {0.1, 0.5, 0.9}) {
        options.threshold = threshold;
        EXPECT_NEAR(area(target(options, 256, 256)), threshold * 256.0 * 216.0, 250.0);
    }
}

TEST_F(Target, AlphaOfAPng) {
    // 8 x 8, white; opaque in the middle 4 x 4.
    const std::string bytes(
        "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x08"
        "\x00\x00\x00\x08\x08\x06\x00\x00\x00\xc4\x0f\xbe\x8b\x00\x00\x00\x19\x49\x44\x41"
        "\x54\x78\xda\x63\xf8\xff\xff\x3f\x03\x3e\xcc\x40\x8a\x02\x74\x30\x10\x0a\xc8\xf3"
        "\x05\x00\x23\xc5\xcf\x31\x32\xad\xf2\x21\x00\x00\x00\x00\x49\x45\x4e\x44\xae\x42"
        "\x60\x82",
        82);
    ImageOptions options{.target = file("logo.png", bytes), .reading = Reading::kAlpha};
    EXPECT_EQ(target(options, 8, 8), box(8, 8, 2, 2, 6, 6));
    options.reading = Reading::kDark;
    EXPECT_TRUE(contains(refused(options), "reading = \"alpha\""));
}

TEST_F(Target, AlphaOfADrawing) {
    ImageOptions options{
        .target = svg("a.svg", 100, 100,
                      "<rect x='20' y='20' width='30' height='30' fill='white'/>"
                      "<rect x='60' y='20' width='30' height='30' fill-opacity='0.3'/>"),
        .reading = Reading::kAlpha};
    EXPECT_EQ(target(options), box(100, 100, 20, 20, 50, 50));
    options.threshold = 0.2;
    EXPECT_EQ(area(target(options)), 1800.0);
}

TEST_F(Target, OpaquePictureReadByItsAlpha) {
    const Source source = png("a.png", grey_box(20, 20, 5, 5, 15, 15));
    EXPECT_TRUE(contains(refused({.target = source, .reading = Reading::kAlpha}),
                         "reading = \"dark\""));
}

TEST_F(Target, AllWhite) {
    EXPECT_TRUE(contains(refused({.target = png("a.png", grey_box(9, 9, 0, 0, 0, 0))}),
                         "a.png: no shadow in the target"));
}

TEST_F(Target, AllBlack) {
    EXPECT_TRUE(contains(refused({.target = png("a.png", grey_box(9, 9, 0, 0, 9, 9))}),
                         "a.png: the target is all shadow"));
}

TEST_F(Target, OnePixelIsSaidToBeLittle) {
    const Source dot = png("dot.png", grey_box(100, 100, 50, 50, 51, 51));
    EXPECT_EQ(area(target({.target = dot})), 1.0);
    EXPECT_TRUE(contains(told_.warnings, "its shadow is 1 cell in all"))
        << told_.warnings;
}

TEST_F(Target, ThinLinesAreSaidToVanish) {
    // A box of 40 x 40, and a line as long as the land and a quarter of a cell wide.
    const Source source = svg("thin.svg", 100, 100,
                              "<rect x='10' y='10' width='40' height='40'/>"
                              "<rect x='0' y='80.3' width='100' height='0.25'/>");
    EXPECT_EQ(target({.target = source}), box(100, 100, 10, 10, 50, 50));
    EXPECT_TRUE(contains(told_.warnings, "1.5% of its shadow is thinner than a cell"))
        << told_.warnings;
    target({.target = source}, 1000, 1000);
    EXPECT_EQ(told_.warnings, "");
}

TEST_F(Target, BeyondTheLandIsSaid) {
    ImageOptions options{.target = png("a.png", grey_box(100, 100, 40, 40, 60, 60))};
    options.placing.position = {1.0, 0.5};
    EXPECT_EQ(target(options), box(100, 100, 90, 40, 100, 60));
    EXPECT_TRUE(contains(told_.warnings, "50% of its shadow lies beyond the land"));
    options.placing.position = {2.0, 0.5};
    EXPECT_TRUE(contains(refused(options), "beyond the extent"));
}

TEST_F(Target, DrawingWithoutASize) {
    const Source source =
        file("a.svg", "<svg xmlns='http://www.w3.org/2000/svg'><circle r='9'/></svg>");
    EXPECT_TRUE(contains(refused({.target = source}), "give its <svg> a viewBox"));
}

TEST_F(Target, FilesThatAreNoPictures) {
    EXPECT_TRUE(contains(refused({.target = file("a.png", "no picture")}), "a.png"));
    EXPECT_TRUE(contains(refused({.target = file("a.svg", "<svg")}), "a.svg"));
}

TEST_F(Text, FitsTheLandWithLightAround) {
    const Mask word = target({.text = "TEXT"}, 256, 256);
    int left = 256, right = -1, top = 256, bottom = -1;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            if (word(x, y)) {
                left = std::min(left, x), right = std::max(right, x);
                top = std::min(top, y), bottom = std::max(bottom, y);
            }
    EXPECT_NEAR(left, 255 - right, 2);
    EXPECT_NEAR(top, 255 - bottom, 2);
    EXPECT_GT(right - left, 200);
    EXPECT_GE(left, 10);
    EXPECT_LT(bottom - top, 100);
    EXPECT_EQ(told_.warnings, "");
}

TEST_F(Text, IsTheSameLandAtAnySize) {
    const Mask coarse = target({.text = "Ag"}, 100, 100);
    const Mask fine = target({.text = "Ag"}, 800, 800);
    Mask every_eighth(100, 100);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) every_eighth(x, y) = fine(8 * x + 4, 8 * y + 4);
    EXPECT_GT(iou(coarse, every_eighth), 0.95);
}

TEST_F(Text, LettersOfMarkupAreLetters) {
    const Mask word = target({.text = "<&>"});
    EXPECT_GT(area(word), 300.0);
    EXPECT_NE(word, target({.text = "&amp;"}));
}

TEST_F(Text, LettersOfAnySizeAreDrawn) {
    for (const char* text :
         {".", "A", "a long line of fifty letters, one after the other"})
        for (const int side : {100, 1000})
            EXPECT_GT(area(target({.text = text}, side, side)), 20.0) << text << side;
}

TEST_F(Text, FontIsTheOneAskedFor) {
    const Mask sans = target({.text = "Mill"});
    const Mask serif = target({.text = "Mill", .font = "dejavu serif"});
    EXPECT_EQ(told_.warnings, "");
    EXPECT_LT(iou(sans, serif), 0.8);
    // Bold is a style of the family, and heavier.
    const Mask book = target({.text = "Mill", .font = "DejaVu Sans"});
    EXPECT_EQ(told_.warnings, "");
    EXPECT_GT(area(sans), 1.1 * area(book));
}

TEST_F(Text, FontThatIsNotInstalled) {
    target({.text = "Mill", .font = "No Such Font"});
    EXPECT_TRUE(contains(told_.warnings, "font 'No Such Font' is not installed: '"))
        << told_.warnings;
}

TEST_F(Text, LettersThatNoFontHas) {
    EXPECT_TRUE(contains(refused({.text = "a\xf3\xb0\x80\x80"}),
                         "no installed font has a shape for U+F0000"));
}

TEST_F(Text, ThatIsNotALine) {
    EXPECT_TRUE(contains(refused({.text = ""}), "it has no visible letter"));
    EXPECT_TRUE(contains(refused({.text = "  "}), "it has no visible letter"));
    EXPECT_TRUE(contains(refused({.text = "a\nb"}), "control character U+000A"));
    EXPECT_TRUE(contains(refused({.text = "a\xff"}), "not UTF-8"));
    EXPECT_TRUE(contains(refused({.text = std::string(300, 'a')}), "at most 256"));
}

TEST_F(Target, NamesAreFoldersAndNoTwoAlike) {
    const Source a = png("a b.png", grey_box(4, 4, 1, 1, 2, 2));
    EXPECT_EQ(image_name({.target = a}), "a_b");
    EXPECT_EQ(image_name({.text = "../x/\xc3\xa4"}), "___x___");
    EXPECT_EQ(image_name({.text = "\xe6\x97\xa5"}), "text");
    EXPECT_EQ(image_name({.text = std::string(200, 'x')}).size(), 48u);
    const std::vector<std::string> names = image_names(
        {{.text = "a"}, {.text = "A"}, {.text = "a"}, {.text = "a-2"}, {.text = "b"}});
    EXPECT_EQ(names, (std::vector<std::string>{"a", "A-2", "a-3", "a-2-2", "b"}));
}

}  // namespace
}  // namespace cydonia::pareidolia
