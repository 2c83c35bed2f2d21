#include "field/strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "field/svg.h"
#include "tests/field/raster.h"

namespace cydonia {
namespace {

constexpr Rgba8 kNothing{};
constexpr Rgba8 kRed{255, 0, 0, 255};
constexpr Rgba8 kBlue{0, 0, 255, 255};

std::string svg(std::string_view head, std::string_view body) {
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" {}>{}</svg>", head,
                       body);
}

Field<Rgba8> strokes_of(const std::string& text, int width, int height) {
    const TemporaryFolder folder;
    return read_strokes(open_source(folder.with("a.svg", text)), width, height);
}

std::set<Rgba8> colours_in(const Field<Rgba8>& image) {
    return {image.begin(), image.end()};
}

long count_drawn(const Field<Rgba8>& image) {
    return std::count_if(image.begin(), image.end(),
                         [](Rgba8 p) { return p != kNothing; });
}

TEST(SvgStrokes, TwoCrossingColoursStayTwo) {
    const std::string text = svg("viewBox='0 0 100 100'",
                                 "<path d='M3 7 L91 83' stroke='#f00' stroke-width='5'/>"
                                 "<circle cx='50' cy='50' r='30.3' fill='none' "
                                 "stroke='#00f' stroke-width='3'/>");
    for (const int size : {17, 64, 300})
        EXPECT_EQ(colours_in(strokes_of(text, size, size)),
                  (std::set{kNothing, kRed, kBlue}))
            << size;
}

TEST(ReadSvg, CrispEdgesHaveNoColourBetween) {
    const TemporaryFolder folder;
    const Source source = open_source(folder.with(
        "a.svg",
        svg("viewBox='0 0 100 100'",
            "<path d='M3 7 L91 83' stroke='#f00' stroke-width='5'/>"
            "<path d='M91 7 Q40 50 3 83' stroke='#00f' stroke-width='5' "
            "fill='none'/><text x='5' y='60' font-size='40' fill='#00f'>T</text>")));
    EXPECT_EQ(colours_in(read_svg(source, 64, 64, SvgEdges::kCrisp)),
              (std::set{kNothing, kRed, kBlue}));
    EXPECT_GT(colours_in(read_svg(source, 64, 64, SvgEdges::kSmooth)).size(), 10u);
}

TEST(SvgStrokes, TextIsCrispToo) {
    const std::string text =
        svg("viewBox='0 0 100 100'",
            "<text x='5' y='60' font-size='40' fill='#00f'>TEXT</text>");
    EXPECT_EQ(colours_in(strokes_of(text, 128, 128)), (std::set{kNothing, kBlue}));
}

TEST(SvgStrokes, ThinStrokeStaysAndStaysConnected) {
    const std::string text =
        svg("viewBox='0 0 5120 5120'",
            "<path d='M100 300 L5000 4000' stroke='#f00' stroke-width='4'/>");
    const Field<Rgba8> cells = strokes_of(text, 64, 64);
    int last = 64;
    for (int x = 2; x < 62; ++x) {
        int top = 64, bottom = -1;
        for (int y = 0; y < 64; ++y)
            if (cells(x, y) == kRed) top = std::min(top, y), bottom = y;
        ASSERT_GE(bottom, 0) << "no cell in column " << x;
        EXPECT_LE(bottom - top, 2) << "too thick in column " << x;
        EXPECT_LE(top, last + 1) << "a gap before column " << x;
        last = bottom;
    }
}

TEST(SvgStrokes, StretchedToTheGrid) {
    // The right half of the page, for each way to give a page its size.
    for (const char* head : {"viewBox='0 0 200 100'", "width='200' height='100'",
                             "width='40' height='20' viewBox='0 0 200 100'"}) {
        const Field<Rgba8> cells = strokes_of(
            svg(head, "<rect x='100' y='0' width='100' height='100' fill='#f00'/>"), 10,
            20);
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 10; ++x)
                ASSERT_EQ(cells(x, y), x < 5 ? kNothing : kRed) << head << x << "," << y;
    }
}

TEST(SvgStrokes, HalfOpaqueIsDrawnFaintIsNot) {
    const auto rect = [](double opacity) {
        return svg("viewBox='0 0 9 9'",
                   fmt::format("<rect width='9' height='9' fill='#00f' opacity='{}'/>",
                               opacity));
    };
    EXPECT_EQ(colours_in(strokes_of(rect(0.6), 4, 4)), std::set{kBlue});
    expect_error(ExitCode::kBadRequest, "nothing is drawn",
                 [&] { strokes_of(rect(0.4), 4, 4); });
}

TEST(SvgStrokes, NothingDrawn) {
    for (const char* body :
         {"", "<rect width='9' height='9' fill='white'/>", "<path d='M1 1 L8 8'/>",
          "<rect x='20' width='5' height='5'/>"})
        expect_error(ExitCode::kBadRequest, "a.svg: nothing is drawn",
                     [&] { strokes_of(svg("viewBox='0 0 9 9'", body), 8, 8); });
}

TEST(SvgStrokes, FilesItNamesAreNotOpened) {
    const TemporaryFolder folder;
    write_png(folder / "secret.png", Field<Rgb8>(4, 4, {255, 0, 0}));
    const std::string url = (folder / "secret.png").string();
    const std::string text =
        "<!DOCTYPE svg [<!ENTITY file SYSTEM \"" + url + "\">]>" +
        svg("viewBox='0 0 9 9' xmlns:xlink='http://www.w3.org/1999/xlink'",
            "<image href='file://" + url + "' width='9' height='9'/>" +
                "<image xlink:href='" + url + "' width='9' height='9'/>" +
                "<image href='secret.png' width='9' height='9'/>");
    expect_error(ExitCode::kBadRequest, "nothing is drawn",
                 [&] { read_strokes(open_source(folder.with("a.svg", text)), 8, 8); });
}

TEST(SvgStrokes, BrokenDrawings) {
    const std::string whole =
        svg("viewBox='0 0 9 9'", "<path d='M1 1 L8 8' stroke='#f00'/>");
    for (std::size_t length = 1; length < whole.size(); ++length)
        EXPECT_FALSE(survives([&] { strokes_of(whole.substr(0, length), 8, 8); }))
            << length;
    for (const char* text :
         {"<html/>", "<svg", "<!-- only -->", "< >", "<svg xmlns='x'/>"})
        EXPECT_FALSE(survives([&] { strokes_of(text, 8, 8); })) << text;
    EXPECT_FALSE(survives([&] {
        strokes_of(svg("width='0' height='0'", "<rect width='9' height='9'/>"), 8, 8);
    }));
}

TEST(SvgStrokes, EntityBombEnds) {
    std::string entities =
        "<!DOCTYPE svg [<!ENTITY a \"<rect width='.001' height='.001'/>\">";
    for (int i = 1; i < 12; ++i) {
        std::string tenfold;
        for (int k = 0; k < 10; ++k) tenfold += fmt::format("&{};", char('a' + i - 1));
        entities += fmt::format("<!ENTITY {} \"{}\">", char('a' + i), tenfold);
    }
    EXPECT_FALSE(survives(
        [&] { strokes_of(entities + "]>" + svg("viewBox='0 0 9 9'", "&l;"), 8, 8); }));
}

TEST(ImageStrokes, SameSizeIsKept) {
    const TemporaryFolder folder;
    Field<Rgb8> image(8, 8, {255, 255, 255});
    image(3, 4) = {255, 0, 0};
    image(4, 4) = {0, 0, 255};
    write_png(folder / "a.png", image);
    const Field<Rgba8> cells = read_strokes(open_source(folder / "a.png"), 8, 8);
    EXPECT_EQ(cells(3, 4), kRed);
    EXPECT_EQ(cells(4, 4), kBlue);
    EXPECT_EQ(count_drawn(cells), 2);
}

TEST(ImageStrokes, EveryPixelSurvivesShrinking) {
    const TemporaryFolder folder;
    for (int at = 0; at < 100; at += 3) {
        Field<Rgb8> image(100, 37, {255, 255, 255});
        image(at, at * 36 / 99) = {255, 0, 0};
        write_png(folder / "a.png", image);
        const Field<Rgba8> cells = read_strokes(open_source(folder / "a.png"), 7, 11);
        ASSERT_EQ(count_drawn(cells), 1) << at;
        ASSERT_EQ(cells(int((at + 0.5) * 0.07), int((at * 36 / 99 + 0.5) * 11 / 37)),
                  kRed)
            << at;
    }
}

TEST(ImageStrokes, GrowingTakesTheNearestPixel) {
    const TemporaryFolder folder;
    Field<Rgb8> image(3, 2, {255, 255, 255});
    image(1, 0) = {255, 0, 0};
    write_png(folder / "a.png", image);
    const Field<Rgba8> cells = read_strokes(open_source(folder / "a.png"), 10, 6);
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 10; ++x) {
            const bool drawn = int((x + 0.5) * 0.3) == 1 && y < 3;
            ASSERT_EQ(cells(x, y), drawn ? kRed : kNothing) << x << "," << y;
        }
}

TEST(ImageStrokes, WhiteOrTransparentIsNothing) {
    const TemporaryFolder folder;
    write_png(folder / "white.png", Field<Rgb8>(4, 4, {255, 255, 255}));
    const Raster clear{4,  4,       std::vector(4, std::vector<float>(16, 0.0f)),
                       {}, nullptr, GDT_Byte};
    write_copy(folder / "clear.png", "PNG", clear);
    for (const char* name : {"white.png", "clear.png"})
        expect_error(ExitCode::kBadRequest, "nothing is drawn",
                     [&] { read_strokes(open_source(folder / name), 8, 8); });
}

TEST(GreyAt, SvgIsAntialiasedOverWhite) {
    const TemporaryFolder folder;
    const Source source = open_source(folder.with(
        "a.svg",
        svg("viewBox='0 0 8 8'", "<rect x='2' width='3' height='8' fill='black'/>")));
    const Field<float> grey = read_grey_at(source, 4, 2);
    for (int y = 0; y < 2; ++y) {
        EXPECT_NEAR(grey(0, y), 1.0f, 1e-5f);
        EXPECT_NEAR(grey(1, y), 0.0f, 1e-5f);
        EXPECT_NEAR(grey(2, y), 0.5f, 1e-2f);
        EXPECT_NEAR(grey(3, y), 1.0f, 1e-5f);
    }
}

TEST(GreyAt, ImageIsAveragedOverItsCells) {
    const TemporaryFolder folder;
    Field<std::uint8_t> image(4, 4, std::uint8_t{255});
    image(0, 0) = image(1, 1) = 0;
    write_png(folder / "a.png", image);
    const Field<float> grey = read_grey_at(open_source(folder / "a.png"), 2, 2);
    EXPECT_FLOAT_EQ(grey(0, 0), 0.5f);
    EXPECT_FLOAT_EQ(grey(1, 1), 1.0f);
}

TEST(IsSvg, ByTheFirstCharacter) {
    const TemporaryFolder folder;
    EXPECT_TRUE(is_svg(open_source(folder.with("a", " \n<svg/>"))));
    EXPECT_TRUE(is_svg(open_source(folder.with("b", "\xef\xbb\xbf<svg/>"))));
    EXPECT_FALSE(is_svg(open_source(folder.with("c.svg", "text"))));
}

}  // namespace
}  // namespace cydonia
