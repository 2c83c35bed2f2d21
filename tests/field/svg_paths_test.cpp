#include "field/svg_paths.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

#include "field/random.h"
#include "field/svg_camera.h"
#include "field/svg_path_data.h"
#include "tests/field/temporary_folder.h"

namespace cydonia {
namespace {

constexpr double kTolerance = 1e-5;

std::string drawing(std::string_view body,
                    std::string_view head = "viewBox='0 0 100 100'") {
    return fmt::format("<svg xmlns='http://www.w3.org/2000/svg' {}>{}</svg>", head, body);
}

std::vector<SvgPath> read(std::string_view text) {
    const TemporaryFolder folder;
    return svg_paths(open_source(folder.with("a.svg", text)), kTolerance);
}

std::vector<SvgPath> paths_of(std::string_view body,
                              std::string_view head = "viewBox='0 0 100 100'") {
    return read(drawing(body, head));
}

std::vector<Point2> points_of(std::string_view body,
                              std::string_view head = "viewBox='0 0 100 100'") {
    const auto paths = paths_of(body, head);
    return paths.empty() ? std::vector<Point2>{} : paths[0].points;
}

void expect_points(const std::vector<Point2>& points,
                   const std::vector<Point2>& expected) {
    ASSERT_EQ(points.size(), expected.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int axis = 0; axis < 2; ++axis)
            EXPECT_NEAR(points[i][axis], expected[i][axis], 1e-9) << i;
}

// The greatest distance of the points from a circle.
double off_circle(const std::vector<Point2>& points, Point2 middle, double radius) {
    double worst = 0.0;
    for (const Point2& p : points)
        worst = std::max(
            worst, std::abs(std::hypot(p[0] - middle[0], p[1] - middle[1]) - radius));
    return worst;
}

TEST(SvgPaths, LinesAsTheyAreDrawn) {
    expect_points(
        points_of("<path d='M10 20L30,40 h20 v-10 l-5.5.5H0V0'/>"),
        {{.1, .2}, {.3, .4}, {.5, .4}, {.5, .3}, {.445, .305}, {0, .305}, {0, 0}});
    expect_points(points_of("<path d='m10 20 10 10 10-10z'/>"),
                  {{.1, .2}, {.2, .3}, {.3, .2}, {.1, .2}});
    expect_points(points_of("<line x1='10' y1='10' x2='50%' y2='90'/>"),
                  {{.1, .1}, {.5, .9}});
    expect_points(points_of("<polyline points='0,0 10,10 10,10 20 0'/>"),
                  {{0, 0}, {.1, .1}, {.2, 0}});
    EXPECT_EQ(points_of("<polygon points='0,0 10,10 20 0'/>").size(), 4u);
    EXPECT_EQ(points_of("<rect x='10' y='10' width='5' height='5'/>").size(), 5u);
}

TEST(SvgPaths, APathOfSeveralRunsOfThePen) {
    const auto paths = paths_of("<path id='p' d='M0 0H10ZL0 10M50 50l10 0'/>");
    ASSERT_EQ(paths.size(), 3u);
    expect_points(paths[1].points, {{0, 0}, {0, .1}});
    expect_points(paths[2].points, {{.5, .5}, {.6, .5}});
    for (const SvgPath& path : paths) EXPECT_EQ(path.id, "p");
}

TEST(SvgPaths, CircleAndItsArcsAreRound) {
    const auto circle = points_of("<circle cx='50' cy='50' r='25'/>");
    EXPECT_LT(off_circle(circle, {.5, .5}, .25), 1e-4);
    EXPECT_EQ(circle.front(), circle.back());
    // Four arcs from the same two points: small or large, on either side.
    EXPECT_LT(
        off_circle(points_of("<path d='M50 25A25 25 0 0 1 75 50'/>"), {.5, .5}, .25),
        1e-4);
    EXPECT_LT(
        off_circle(points_of("<path d='M50 25A25 25 0 1 0 75 50'/>"), {.5, .5}, .25),
        1e-4);
    EXPECT_LT(
        off_circle(points_of("<path d='M50 25A25 25 0 0 0 75 50'/>"), {.75, .25}, .25),
        1e-4);
    EXPECT_LT(
        off_circle(points_of("<path d='M50 25a25 25 0 1125 25'/>"), {.75, .25}, .25),
        1e-4);
    // An ellipse that is too small becomes the half circle between the points.
    EXPECT_LT(off_circle(points_of("<path d='M20 50A1 1 0 0 1 80 50'/>"), {.5, .5}, .3),
              1e-4);
}

TEST(SvgPaths, BezierCurvesPassWhereTheyShould) {
    // Each of these is the parabola y = x (1 - x) of the page.
    for (const char* d : {"M0 0Q50 50 100 0",
                          "M0 0C33.3333333 33.3333333 66.6666667 "
                          "33.3333333 100 0"}) {
        const auto points = points_of(fmt::format("<path d='{}'/>", d));
        EXPECT_GT(points.size(), 20u);
        for (const Point2& p : points) EXPECT_NEAR(p[1], p[0] * (1.0 - p[0]), 1e-8);
    }
    // Smooth curves mirror the handle before them.
    expect_points(points_of("<path d='M0 0Q10 10 20 0T40 0'/>"),
                  points_of("<path d='M0 0Q10 10 20 0Q30-10 40 0'/>"));
    expect_points(points_of("<path d='M0 0C0 9 10 10 20 0S30 0 40 0'/>"),
                  points_of("<path d='M0 0C0 9 10 10 20 0C30-10 30 0 40 0'/>"));
}

TEST(SvgPaths, TransformsOfGroupsApply) {
    const std::string_view line = "<line x2='10' y2='0'/>";
    const auto moved = [&](std::string_view transform) {
        return points_of(
            fmt::format("<g transform='translate(10 20)'><g transform='{}'>{}</g></g>",
                        transform, line));
    };
    expect_points(moved(""), {{.1, .2}, {.2, .2}});
    expect_points(moved("scale(2)"), {{.1, .2}, {.3, .2}});
    expect_points(moved("rotate(90)"), {{.1, .2}, {.1, .3}});
    expect_points(moved("rotate(90, 10, 0) scale(2,1)"), {{.2, .1}, {.2, .3}});
    expect_points(moved("matrix(0 1 -1 0 5 5)"), {{.15, .25}, {.15, .35}});
    expect_points(moved("skewY(45)"), {{.1, .2}, {.2, .3}});
}

TEST(SvgPaths, SharesOfThePage) {
    const std::string_view line = "<line x1='10' y1='10' x2='20' y2='30'/>";
    // Millimetres with a viewBox, as Inkscape writes them.
    expect_points(points_of(line, "width='200mm' height='400mm' viewBox='0 0 200 400'"),
                  {{.05, .025}, {.1, .075}});
    expect_points(points_of(line, "width='100' height='50'"), {{.1, .2}, {.2, .6}});
    // A square box in the middle of a wide page.
    expect_points(points_of(line, "width='200' height='100' viewBox='0 0 100 100'"),
                  {{.3, .1}, {.35, .3}});
    expect_points(points_of(line,
                            "width='200' height='100' viewBox='0 0 100 100' "
                            "preserveAspectRatio='none'"),
                  {{.1, .1}, {.2, .3}});
    expect_points(points_of(line,
                            "width='200' height='100' viewBox='10 10 100 100' "
                            "preserveAspectRatio='xMinYMin slice'"),
                  {{0, 0}, {.1, .4}});
}

TEST(SvgPaths, OnlyWhatIsDrawn) {
    const auto paths = paths_of(
        "<defs><path d='M0 0H10'/></defs><path d='M0 0H10' display='none'/>"
        "<g style='fill:none; display: none'><path d='M0 0H10'/></g>"
        "<path d=''/><path d='M5 5'/><circle r='0'/><text>M0 0H10</text>"
        "<g id='group'><path d='M0 0H10'/><path id='own' d='M0 0H10'/></g>");
    ASSERT_EQ(paths.size(), 2u);
    EXPECT_EQ(paths[0].id, "group");
    EXPECT_EQ(paths[1].id, "own");
}

// Paths have the names that a user gives: the label of a layer, the id of a group, or
// their own id.
TEST(SvgPaths, PathsAreCalledByIdsAndLabelsAroundThem) {
    const auto paths = paths_of(
        "<g xmlns:i='http://www.inkscape.org/namespaces/inkscape' id='layer1' "
        "i:label='peaks'><path id='path7' d='M0 0H10'/></g><path d='M0 0H10'/>");
    ASSERT_EQ(paths.size(), 2u);
    for (const char* name : {"path7", "layer1", "peaks"})
        EXPECT_TRUE(paths[0].is_called(name)) << name;
    EXPECT_FALSE(paths[0].is_called("cliff"));
    EXPECT_FALSE(paths[1].is_called("peaks"));
}

TEST(SvgCamera, IsReadAsItWasWritten) {
    Camera camera;
    camera.eye = {-1234.5678, 0.1, 1e-3};
    camera.target = {1.0 / 3.0, 5000.0, -20.0};
    camera.field_of_view = 0.7;
    const TemporaryFolder folder;
    const auto read = svg_camera(open_source(folder.with(
        "a.svg", drawing("<metadata>" + svg_camera_text(camera) + "</metadata>",
                         "width='640' height='360'"))));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->eye, camera.eye);
    EXPECT_EQ(read->target, camera.target);
    EXPECT_NEAR(read->field_of_view, 0.7, 1e-15);
    EXPECT_EQ(read->width * 9, read->height * 16);
    EXPECT_FALSE(svg_camera(open_source(
        folder.with("b.svg", drawing("<metadata><camera eye='1 2 3'/></metadata>")))));
}

TEST(SvgPaths, WhatCannotBeReadIsNamed) {
    const auto refused = [](std::string_view body, std::string_view words) {
        expect_error(ExitCode::kBadRequest, words, [&] { paths_of(body); });
    };
    refused("<path id='river' d='M0 0L5'/>", "river: a path cannot be read from");
    refused("<path d='0 0L5 5'/>", "cannot be read");
    refused("<path d='M0 0Z5 5'/>", "cannot be read");
    refused("<path d='M0 0A5 5 0 2 0 5 5'/>", "cannot be read");
    refused("<path d='M0 0L1e999 0'/>", "cannot be read");
    refused("<path d='M0 0L1e300 0'/>", "a million pages away");
    refused("<path d='M0 0Lnan inf'/>", "cannot be read");
    refused("<circle r='wide'/>", "r='wide' is no length");
    refused("<g transform='turn(3)'/>", "transform");
    refused("<polyline points='1 2 3'/>", "points=");
    expect_error(ExitCode::kBadRequest, "a.svg", [] { read("<html/>"); });
    expect_error(ExitCode::kBadRequest, "a.svg", [] { read("<svg"); });
}

TEST(SvgPaths, EntitiesDoNotGrow) {
    std::string entities = "<!DOCTYPE svg [<!ENTITY a '10 10 '>";
    for (char c = 'b'; c < 'n'; ++c) {
        entities += fmt::format("<!ENTITY {} '", c);
        for (int i = 0; i < 10; ++i) entities += fmt::format("&{};", char(c - 1));
        entities += "'>";
    }
    survives([&] { read(entities + "]>" + drawing("<path d='M0 0 &m;'/>&m;")); });
}

TEST(SvgPaths, DamagedBytesNeverCrash) {
    const std::string whole = drawing(
        "<g transform='rotate(30 5 5)'><path id='a' d='M1 1C5 5 6 6 7 7S1 2 3 4q1 2 3 "
        "4t5 6"
        "a5 6 7 1 0 8 9z'/><circle r='5%'/></g><polygon points='1,2 3,4 5,6'/>");
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        std::string text = whole;
        for (std::uint64_t k = 0; k < 3; ++k)
            text[hash_of({seed, k}) % text.size()] = char(hash_of({seed, k, 1}) % 256);
        survives([&] { read(text); });
    }
}

}  // namespace
}  // namespace cydonia
