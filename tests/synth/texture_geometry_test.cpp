#include "synth/texture/constraints/geometry.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "field/random.h"
#include "synth/geometry/hermite.h"
#include "synth/texture/constraints/curve_constraint.h"
#include "tests/field/temporary_folder.h"

namespace cydonia::texture {
namespace {

using namespace geometry;

constexpr Ground kGround{2560.0, 1280.0, 10.0};

class Warnings final : public Progress {
  public:
    void step(std::string_view) override {}
    void report(double) override {}
    void note(std::string_view) override {}
    void warn(std::string_view sentence) override { all.emplace_back(sentence); }
    std::vector<std::string> all;
};

Place2 place(double x, double y) { return {metres(x), metres(y)}; }

Curve curve(std::vector<Place2> points, double height, double area = 200.0) {
    Curve c;
    c.name = "curve";
    c.points = std::move(points);
    c.height = height;
    c.area = {metres(area), metres(area)};
    return c;
}
Curve named(std::string name, Curve c) {
    c.name = std::move(name);
    return c;
}
Handle handle(double at, std::optional<double> height) { return {at, height, {}, {}}; }

Point point(std::string name, double x, double y, double height, double radius = 200.0) {
    Point p;
    p.name = std::move(name);
    p.at = place(x, y);
    p.height = height;
    p.radius = metres(radius);
    return p;
}

double flat(double, double) { return 0.0; }

struct Made {
    Warnings warnings;
    Geometry geometry;
    explicit Made(const Options& options, const HeightAt& natural = flat)
        : geometry(options, kGround, natural, warnings) {}
};
Options with(std::vector<Curve> curves, std::vector<Point> points = {}) {
    Options options;
    options.curves = std::move(curves);
    options.points = std::move(points);
    return options;
}

Window whole(int level) {
    return {level, 0, 0, int(kGround.width / kGround.spacing) >> level,
            int(kGround.depth / kGround.spacing) >> level};
}
double east(const Window& w, int i) {
    return (w.x + i + 0.5) * std::ldexp(10.0, w.level);
}
double north(const Window& w, int j) {
    return kGround.depth - (w.y + j + 0.5) * std::ldexp(10.0, w.level);
}
// Of the cell that a place is in.
Pull pull_at(const Geometry& geometry, double x, double y, int level) {
    const double cell = std::ldexp(10.0, level);
    return geometry.pulls({level, int(std::floor(x / cell)),
                           int(std::floor((kGround.depth - y) / cell)), 1, 1})(0, 0);
}
double site_height(const Geometry& geometry, double x, double y) {
    double best = 1e9, height = 0.0;
    for (const auto& site : geometry.sites())
        if (const double d = std::hypot(site.x - x, site.y - y); d < best)
            best = d, height = site.height;
    return height;
}

TEST(TextureGeometry, NothingIsFree) {
    const Made made((Options()));
    EXPECT_TRUE(made.geometry.empty());
    for (const Pull& pull : made.geometry.pulls({0, -5, -5, 20, 20}))
        EXPECT_EQ(pull.reach, 0.0f);
}

// A line from west to east: left is north.
TEST(TextureGeometry, AStraightLineHasTwoSides) {
    Curve c = curve({place(300, 600), place(2000, 600)}, 50.0);
    c.gradient = {-0.5, 0.25};
    c.area = {metres(120.0), metres(60.0)};
    const Made made(with({c}));
    for (int level : {0, 2}) {
        const Window window = whole(level);
        const double cell = std::ldexp(10.0, level);
        const auto pulls = made.geometry.pulls(window);
        for (int j = 0; j < window.height; ++j)
            for (int i = 0; i < window.width; ++i) {
                const double x = east(window, i), away = north(window, j) - 600.0;
                if (x < 400.0 || x > 1900.0) continue;  // not around the ends
                const Pull& pull = pulls(i, j);
                const double d = std::abs(away), area = away > 0.0 ? 120.0 : 60.0;
                const double reach = std::min(area, 4.0 * cell);
                if (d >= reach) {
                    EXPECT_EQ(pull.reach, 0.0f) << x << " " << away;
                    continue;
                }
                EXPECT_NEAR(pull.distance, d, 1e-3);
                EXPECT_NEAR(pull.reach, reach, 1e-3);
                EXPECT_NEAR(pull.target, 50.0 + (away > 0.0 ? -0.5 : 0.25) * d, 1e-3);
            }
    }
}

TEST(TextureGeometry, DistancesToACircle) {
    const TemporaryFolder folder;
    Curve c = curve({}, 10.0, 300.0);
    c.drawing = open_source(
        folder.with("ring.svg",
                    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2560 1280'>"
                    "<circle id='ring' cx='1000' cy='480' r='400'/></svg>"));
    const Made made(with({c}));
    EXPECT_EQ(made.geometry.names(), std::vector<std::string>{"curve/ring"});
    const Window window = whole(4);
    const auto pulls = made.geometry.pulls(window);
    int near = 0;
    for (int j = 0; j < window.height; ++j)
        for (int i = 0; i < window.width; ++i) {
            const double d = std::abs(
                std::hypot(east(window, i) - 1000.0, north(window, j) - 800.0) - 400.0);
            if (pulls(i, j).reach > 0.0f) {
                EXPECT_NEAR(pulls(i, j).distance, d, 0.5);
            }
            near += d < 299.0;
            EXPECT_EQ(pulls(i, j).reach > 0.0f, d < 300.0) << i << " " << j;
        }
    EXPECT_GT(near, 50);
}

TEST(TextureGeometry, APointHasAGradient) {
    Point p = point("peak", 705.0, 605.0, 90.0, 75.0);
    p.gradient = {0.2, -0.1};
    const Made made(with({}, {p}));
    EXPECT_EQ(pull_at(made.geometry, 705, 605, 0).target, 90.0f);
    EXPECT_NEAR(pull_at(made.geometry, 725, 595, 0).target, 90.0 + 4.0 + 1.0, 1e-4);
    EXPECT_EQ(pull_at(made.geometry, 705, 605, 0).reach, 40.0f);
    EXPECT_EQ(pull_at(made.geometry, 750, 605, 3).reach, 75.0f);
    EXPECT_EQ(pull_at(made.geometry, 785, 605, 0).reach, 0.0f);
}

TEST(TextureGeometry, HandlesAreInterpolatedAlongTheCurve) {
    Curve c = curve({place(105, 605), place(2105, 605)}, 7.0);
    c.handles = {handle(0.75, 300.0), handle(0.25, 100.0)};
    c.handles[1].gradient = {{0.5, 0.0}};
    c.handles[1].area = {{metres(30.0), metres(80.0)}};
    const Made made(with({c}));
    EXPECT_NEAR(pull_at(made.geometry, 205, 605, 0).target, 100.0, 1e-3);
    EXPECT_NEAR(pull_at(made.geometry, 2005, 605, 0).target, 300.0, 1e-3);
    EXPECT_NEAR(pull_at(made.geometry, 1105, 605, 0).target, 200.0, 1.0);
    float before = 0.0f;
    for (double x = 105; x < 2105; x += 10) {
        const float here = pull_at(made.geometry, x, 605, 0).target;
        EXPECT_GE(here, before - 1e-4f) << x;
        before = here;
    }
    EXPECT_NEAR(pull_at(made.geometry, 1505, 625, 0).target, 296.0 + 0.5 * 20.0, 14.0);
    EXPECT_NEAR(pull_at(made.geometry, 605, 625, 0).reach, 30.0, 1e-3);
    EXPECT_NEAR(pull_at(made.geometry, 605, 585, 0).reach, 40.0, 1e-3);
}

TEST(TextureGeometry, HermiteKeepsBetweenItsKnots) {
    const Hermite h({{0.5, 1.0}, {1.0, 2.0}, {4.0, 8.0}, {5.0, 3.0}}, 9.0, false);
    EXPECT_EQ(h(0.0), 1.0);
    EXPECT_EQ(h(9.0), 3.0);
    EXPECT_NEAR(h(4.0), 8.0, 1e-12);
    for (double t = 0.0; t <= 5.0; t += 0.01) {
        EXPECT_GE(h(t), t < 4.0 ? 1.0 : 3.0);
        EXPECT_LE(h(t), 8.0);
        EXPECT_NEAR((h(t + 1e-6) - h(t - 1e-6)) / 2e-6,
                    (h(t + 1e-4) - h(t - 1e-4)) / 2e-4, 2e-3)
            << t;  // no bend
    }
    const Hermite ring({{1.0, 0.0}, {6.0, 4.0}}, 10.0, true);
    EXPECT_NEAR(ring(0.0), ring(10.0), 1e-12);
    EXPECT_NEAR(ring(8.5), 2.0, 1e-12);
    const Hermite even({{0.0, 420.0}, {10.0, 260.0}}, 10.0, false);
    for (double t = 0.0; t <= 10.0; ++t) EXPECT_NEAR(even(t), 420.0 - 16.0 * t, 1e-9);
}

TEST(TextureGeometry, SmoothCurvesPassTheirPoints) {
    const std::vector<Place2> points{place(205, 205), place(605, 905), place(1005, 305),
                                     place(1015, 305), place(2005, 1005)};
    const Made made(with({curve(points, 5.0)}));
    for (const Place2& p : points)
        EXPECT_LT(pull_at(made.geometry, p[0].metres, p[1].metres, 0).distance, 0.01);
    // Without corners: neighbouring sites turn little.
    const auto& sites = made.geometry.sites();
    for (std::size_t i = 2; i < sites.size(); ++i) {
        const double ax = sites[i - 1].x - sites[i - 2].x,
                     ay = sites[i - 1].y - sites[i - 2].y;
        const double bx = sites[i].x - sites[i - 1].x, by = sites[i].y - sites[i - 1].y;
        EXPECT_GT((ax * bx + ay * by) / std::hypot(ax, ay) / std::hypot(bx, by), 0.5);
    }
}

// Outside a corner the nearest point is the corner itself, which lies on two lines.
TEST(TextureGeometry, CornersKeepTheirSides) {
    const TemporaryFolder folder;
    Curve c = curve({}, 100.0);
    c.gradient = {1.0, -1.0};
    c.drawing = open_source(
        folder.with("a.svg",
                    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2560 1280'>"
                    "<path d='M300 975L600 375L900 975L1200 375L1500 975'/></svg>"));
    const Made made(with({c}));
    const double d = std::hypot(15.0, 10.0);
    for (double side : {-15.0, 15.0}) {
        // Beyond a peak is left of the way, below a valley right.
        EXPECT_NEAR(pull_at(made.geometry, 600 + side, 915, 0).target, 100.0 + d, 1e-3);
        EXPECT_NEAR(pull_at(made.geometry, 900 + side, 295, 0).target, 100.0 - d, 1e-3);
        EXPECT_NEAR(pull_at(made.geometry, 1200 + side, 915, 0).target, 100.0 + d, 1e-3);
    }
}

// Around an end the sides run into each other.
TEST(TextureGeometry, AnEndIsRoundedFromSideToSide) {
    Curve c = curve({place(300, 605), place(1005, 605)}, 100.0);
    c.gradient = {-1.0, 1.0};
    c.area = {metres(40.0), metres(80.0)};
    const Made made(with({c}));
    const auto at = [&](double degrees) {
        const double a = degrees * std::numbers::pi / 180.0;
        return pull_at(made.geometry, 1005 + 30 * std::cos(a), 605 + 30 * std::sin(a), 1);
    };
    EXPECT_NEAR(pull_at(made.geometry, 1025, 605, 0).target, 100.0, 1e-3);
    EXPECT_NEAR(at(0).reach, 60.0, 5.0);
    for (double angle = -80; angle < 80; angle += 10)
        EXPECT_LE(at(angle + 10).target, at(angle).target + 8.0f) << angle;
    EXPECT_GT(at(-80).target, 120.0f);
    EXPECT_LT(at(80).target, 80.0f);
}

Options tangled() {
    Curve a =
        curve({place(-300, 205), place(605, 905), place(1505, 305), place(2905, 1005)},
              50.0, 150.0);
    a.handles = {handle(0.1, 300.0), handle(0.6, 100.0)};
    a.handles[0].area = {{metres(300.0), metres(50.0)}};
    Curve b =
        curve({place(100, 1100), place(2000, 100), place(1000, 100), place(900, 1000)},
              120.0, 400.0);
    b.gradient = {-0.3, 0.2};
    return with({a, b}, {point("p", 500, 500, 70.0), point("q", 1500, 700, 20.0, 500.0)});
}

TEST(TextureGeometry, EveryWindowHasTheSameCells) {
    const Made made(tangled());
    for (int level : {0, 1, 3, 5}) {
        const Window large = whole(level).grown(7);
        const auto pulls = made.geometry.pulls(large);
        for (const Window& part :
             {Window{level, -3, 1, 9, 5},
              Window{level, large.width / 2, 2, 13, large.height / 2},
              Window{level, 2, large.height / 3, large.width / 2, 3}}) {
            const auto cut = made.geometry.pulls(part);
            for (int j = 0; j < part.height; ++j)
                for (int i = 0; i < part.width; ++i) {
                    const int x = part.x + i - large.x, y = part.y + j - large.y;
                    if (!pulls.contains(x, y)) continue;
                    ASSERT_EQ(std::memcmp(&cut(i, j), &pulls(x, y), sizeof(Pull)), 0)
                        << level << ": " << i << ", " << j;
                }
        }
    }
}

TEST(TextureGeometry, EveryNumberOfThreadsGivesTheSameBytes) {
    const auto bytes = [](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                          threads);
        const Made made(tangled());
        std::vector<Pull> all;
        for (int level : {0, 2, 4})
            for (const Pull& pull : made.geometry.pulls(whole(level)))
                all.push_back(pull);
        return all;
    };
    const auto one = bytes(1), four = bytes(4);
    ASSERT_EQ(one.size(), four.size());
    EXPECT_EQ(std::memcmp(one.data(), four.data(), one.size() * sizeof(Pull)), 0);
}

// By the inverse of the distance, which is made to vanish where the influence does.
TEST(TextureGeometry, OverlapsAreWeightedByNearness) {
    const double xs[] = {605.0, 805.0}, radii[] = {300.0, 250.0},
                 heights[] = {100.0, 300.0};
    const Made made(with({}, {point("a", xs[0], 605, heights[0], radii[0]),
                              point("b", xs[1], 605, heights[1], radii[1])}));
    const Window window = whole(3);
    const auto pulls = made.geometry.pulls(window);
    int both = 0;
    for (int j = 0; j < window.height; ++j)
        for (int i = 0; i < window.width; ++i) {
            double sum = 0.0, target = 0.0, reach = 0.0;
            for (int k = 0; k < 2; ++k) {
                const double d =
                    std::hypot(east(window, i) - xs[k], north(window, j) - 605.0);
                if (d >= radii[k]) continue;
                both += k == 1 && sum > 0.0;
                const double weight = 1.0 / d - 1.0 / radii[k];
                sum += weight;
                target += weight * heights[k];
                reach += weight * radii[k];
            }
            ASSERT_EQ(pulls(i, j).reach > 0.0f, sum > 0.0);
            if (sum == 0.0) continue;
            EXPECT_NEAR(pulls(i, j).target, target / sum, 1e-3);
            EXPECT_NEAR(pulls(i, j).reach, reach / sum, 1e-3);
        }
    EXPECT_GT(both, 10);
}

TEST(TextureGeometry, AtACrossingTheEarlierCurveWins) {
    const Made made(
        with({named("ridge", curve({place(200, 600), place(2000, 600)}, 400.0)),
              named("road", curve({place(1000, 100), place(1000, 1200)}, 100.0))}));
    ASSERT_EQ(made.warnings.all.size(), 1u);
    const std::string& warning = made.warnings.all[0];
    for (const char* words :
         {"'road'", "'ridge'", "100 m", "400 m", "(1000, 600)", "wins"})
        EXPECT_NE(warning.find(words), std::string::npos) << words << ": " << warning;
    for (const auto& site : made.geometry.sites())
        if (site.constraint == 0) {
            EXPECT_NEAR(site.height, 400.0, 1e-6);
        }
    // The road rises to it without a step and is itself again far away.
    double before = -1.0;
    for (const auto& site : made.geometry.sites()) {
        if (site.constraint != 1) continue;
        if (before >= 0.0) {
            EXPECT_LT(std::abs(site.height - before), 9.0) << site.y;
        }
        if (std::abs(site.y - 600.0) < 1.0) {
            EXPECT_NEAR(site.height, 400.0, 1.0);
        }
        before = site.height;
    }
    EXPECT_NEAR(site_height(made.geometry, 1000, 1200), 100.0, 1e-6);
    EXPECT_NEAR(site_height(made.geometry, 1000, 100), 100.0, 1e-6);
}

TEST(TextureGeometry, HandlesHoldBesideAJunction) {
    Curve road = named("road", curve({place(1000, 100), place(1000, 1200)}, 100.0));
    road.handles = {handle(0.3, 100.0)};
    const Made made(
        with({named("ridge", curve({place(200, 600), place(2000, 600)}, 160.0)), road}));
    EXPECT_NEAR(site_height(made.geometry, 1000, 600), 160.0, 1e-6);
    EXPECT_NEAR(site_height(made.geometry, 1000, 430), 100.0, 1e-6);
}

TEST(TextureGeometry, ACurveThatCrossesItselfMeetsItself) {
    Curve c = curve(
        {place(300, 300), place(1500, 900), place(1500, 300), place(300, 900)}, 100.0);
    c.handles = {handle(0.0, 0.0), handle(1.0, 200.0)};
    const Made made(with({c}));
    ASSERT_EQ(made.warnings.all.size(), 1u);
    EXPECT_NE(made.warnings.all[0].find("mean"), std::string::npos);
    std::vector<double> heights;
    // Where it crosses, by symmetry.
    for (const auto& site : made.geometry.sites())
        if (std::abs(site.y - 600.0) < 6.0 && site.x < 1400.0)
            heights.push_back(site.height);
    ASSERT_GE(heights.size(), 2u);
    EXPECT_NEAR(heights.front(), 100.0, 3.0);
    EXPECT_NEAR(heights.back(), 100.0, 3.0);
}

TEST(TextureGeometry, AnEndOnAnotherCurveIsAJunction) {
    const Made made(
        with({named("a", curve({place(200, 600), place(2000, 600)}, 40.0)),
              named("b", curve({place(1000, 603), place(1000, 1200)}, 40.5))}));
    EXPECT_TRUE(made.warnings.all.empty());  // half a metre is nothing
    EXPECT_NEAR(site_height(made.geometry, 1000, 604), 40.0, 1e-3);
}

TEST(TextureGeometry, ARingThatIsCrossedWhereItBegins) {
    const TemporaryFolder folder;
    Curve ring = curve({}, 50.0, 100.0);
    ring.drawing = open_source(
        folder.with("ring.svg",
                    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2560 1280'>"
                    "<circle id='ring' cx='1000' cy='480' r='400'/></svg>"));
    const Made made(
        with({named("line", curve({place(1200, 800), place(1600, 800)}, 150.0)), ring}));
    EXPECT_EQ(made.warnings.all.size(), 1u);
    EXPECT_NEAR(site_height(made.geometry, 1400, 800), 150.0, 1e-6);
    EXPECT_NEAR(site_height(made.geometry, 600, 800), 50.0, 1e-6);
    EXPECT_NEAR(site_height(made.geometry, 1380, 900),
                site_height(made.geometry, 1380, 700), 1.0);
    for (const Pull& pull : made.geometry.pulls(whole(2)))
        EXPECT_TRUE(std::isfinite(pull.target));
}

TEST(TextureGeometry, TwoPointsAtOnePlaceTheEarlierWins) {
    const Made made(
        with({named("c", curve({place(705, 100), place(705, 1000)}, 60.0))},
             {point("first", 705, 605, 90.0), point("second", 707, 606, 82.0)}));
    ASSERT_EQ(made.warnings.all.size(), 2u);
    EXPECT_NE(made.warnings.all[0].find("'first' comes first"), std::string::npos);
    for (const auto& site : made.geometry.sites())
        if (site.constraint < 2) {
            EXPECT_NEAR(site.height, 90.0, 1e-6);
        }
    EXPECT_NEAR(pull_at(made.geometry, 705, 605, 0).target, 90.0, 1.0);
}

TEST(TextureGeometry, CurvesOnTopOfEachOther) {
    const Made made(
        with({named("a", curve({place(205, 605), place(2005, 605)}, 300.0)),
              named("b", curve({place(305, 607), place(1905, 607)}, 100.0))}));
    ASSERT_FALSE(made.warnings.all.empty());
    EXPECT_NE(made.warnings.all.back().find("'a' comes first"), std::string::npos)
        << made.warnings.all.back();
    for (const auto& site : made.geometry.sites()) {
        if (site.constraint == 1) {
            EXPECT_NEAR(site.height, 300.0, 11.0);
        }
    }
}

// On the concave side of an arc the nearest point leaps from one end to the other.
TEST(TextureGeometry, TheAreaDoesNotLeapOnTheConcaveSide) {
    std::vector<Point2> arc;
    for (double a = 0.0; a <= std::numbers::pi; a += 0.01)
        arc.push_back({1280.0 + 400.0 * std::cos(a), 300.0 + 400.0 * std::sin(a)});
    Curve c = curve({}, 100.0);
    c.handles = {Handle{0.0, {}, {}, {{metres(800.0), metres(800.0)}}},
                 Handle{1.0, {}, {}, {{metres(250.0), metres(250.0)}}}};
    const Shape shape = shape_through(arc, "arc");
    CurveConstraint curve{"arc", shape, Course(c, "arc", shape, kGround, flat)};
    curve.area = SmoothArea(curve.shape, curve.course, kGround);
    // The largest change of what is left of the area of effect over one cell.
    const auto leap = [&](const auto& area) {
        double worst = 0.0;
        for (double y = 20.0; y < 300.0; y += 20.0)
            for (double x = 1100.0, before = 0.0; x < 1460.0; x += 10.0) {
                const double left = area({x, y});
                if (x > 1100.0) worst = std::max(worst, std::abs(left - before));
                before = left;
            }
        return worst;
    };
    const auto segment = [&](const Point2& p) {
        Field<Nearest> nearest(1, 1);
        add_nearest(shape, {10.0, p[0] - 5.0, p[1] + 5.0, 0, 0, 1, 1}, 2000.0, nearest);
        return nearest(0, 0).segment;
    };
    EXPECT_GT(leap([&](const Point2& p) {
                  const Demand asked = demand_of(shape, curve.course, segment(p), p);
                  return asked.area - asked.distance;
              }),
              300.0);
    EXPECT_LT(leap([&](const Point2& p) {
                  const Demand asked = demand_of(curve, segment(p), p);
                  return asked.area - asked.distance;
              }),
              45.0);
    // Beside the curve nothing is changed, and where it does not leap little.
    for (double a = 0.3; a < 2.9; a += 0.2)
        for (double r : {405.0, 440.0, 500.0}) {
            const Point2 p{1280.0 + r * std::cos(a), 300.0 + r * std::sin(a)};
            const Demand raw = demand_of(shape, curve.course, segment(p), p);
            EXPECT_NEAR(demand_of(curve, segment(p), p).area, raw.area,
                        r < 410.0 ? 1e-9 : 12.0);
        }
}

TEST(TextureGeometry, RelativeHeightsFollowTheLandWithoutItsStones) {
    Curve c = curve({place(205, 605), place(2405, 605)}, 50.0, 150.0);
    c.relative = true;
    Point p = point("p", 500, 900, 30.0);
    p.relative = true;
    const Made made(with({c}, {p}),
                    [](double x, double) { return 0.2 * x + 20.0 * std::sin(x / 5.0); });
    for (const auto& site : made.geometry.sites()) {
        if (site.constraint == 0) {
            EXPECT_NEAR(site.height, 130.0 + 20.0 * std::sin(100.0), 1e-9);
        } else if (site.x > 600.0 && site.x < 2000.0) {
            EXPECT_NEAR(site.height, 50.0 + 0.2 * site.x, 1.5) << site.x;
        }
    }
}

TEST(TextureGeometry, SitesAreInsideAndACellApart) {
    const Made made(tangled());
    const auto& sites = made.geometry.sites();
    ASSERT_GT(sites.size(), 500u);
    for (std::size_t i = 0; i < sites.size(); ++i) {
        EXPECT_GE(sites[i].x, 0.0);
        EXPECT_LE(sites[i].x, kGround.width);
        EXPECT_GE(sites[i].y, 0.0);
        EXPECT_LE(sites[i].y, kGround.depth);
    }
    int gaps = 0;
    for (std::size_t i = 1; i < sites.size(); ++i)
        gaps +=
            sites[i].constraint == sites[i - 1].constraint &&
            std::hypot(sites[i].x - sites[i - 1].x, sites[i].y - sites[i - 1].y) > 10.01;
    EXPECT_EQ(gaps, 0);
    EXPECT_EQ(sites[0].constraint, 0);
    EXPECT_EQ(made.geometry.names(),
              (std::vector<std::string>{"p", "q", "curve", "curve"}));
}

TEST(TextureGeometry, OutsideIsAllowedAndSaid) {
    const Made made(with({named("far", curve({place(-900, -90), place(-500, -90)}, 1.0)),
                          named("half", curve({place(-900, 600), place(500, 600)}, 1.0))},
                         {point("off", 3000, 100, 5.0)}));
    ASSERT_EQ(made.warnings.all.size(), 2u);
    EXPECT_NE(made.warnings.all[0].find("'off' lies outside"), std::string::npos);
    EXPECT_NE(made.warnings.all[1].find("'far' lies outside"), std::string::npos);
    EXPECT_GT(made.geometry.sites().size(), 40u);
}

TEST(TextureGeometry, WhatIsNoCurveIsRefused) {
    const auto refused = [](const Curve& c, std::string_view words) {
        expect_error(ExitCode::kBadRequest, words, [&] { Made made(with({c})); });
    };
    refused(curve({place(1, 1)}, 1.0), "has one point");
    refused(curve({place(1, 1), place(1, 1), place(1, 1)}, 1.0), "no length");
    refused(curve({}, 1.0), "no points");
    refused(curve({place(1, 1), place(1e300, 1)}, 1.0), "million kilometres");
    refused(curve({place(0, NAN), place(1, 1)}, 1.0), "million kilometres");
    refused(curve({place(0, 0), place(1, 1)}, 1.0, -5.0), "area is negative");
    Curve c = curve({place(1, 1), place(900, 900)}, 1.0);
    c.handles = {handle(1.5, 3.0)};
    refused(c, "a handle is at 1.5");
    c.handles = {handle(0.5, 3.0), handle(0.5, 4.0)};
    refused(c, "two handles are at 0.5");
    expect_error(ExitCode::kBadRequest, "radius",
                 [&] { Made made(with({}, {point("p", 1, 1, 1, -1)})); });
}

// Curves that run back over themselves, end where they began, have no area, meet at
// their ends, lie outside: refused, or numbers everywhere.
TEST(TextureGeometry, AnyCurveIsRefusedOrGivesNumbers) {
    int made = 0;
    for (std::uint64_t seed = 0; seed < 80; ++seed) {
        std::uint64_t n = 0;
        const auto draw = [&] { return unit(hash_of({seed, n++})); };
        const auto coordinate = [&] {
            return draw() < 0.5 ? 500.0 * std::floor(5.0 * draw())
                                : 4000.0 * draw() - 700.0;
        };
        Options options;
        for (int c = 0; c < 4; ++c) {
            std::vector<Place2> points;
            for (double i = 0.0; i < 1.0 + 6.0 * draw(); ++i)
                points.push_back(place(coordinate(), coordinate()));
            if (draw() < 0.3) points.push_back(points[0]);
            if (draw() < 0.2) points.insert(points.end(), points.rbegin(), points.rend());
            Curve some =
                curve(points, 500.0 * draw(), draw() < 0.1 ? 0.0 : 600.0 * draw());
            some.relative = draw() < 0.3;
            for (double at : {0.0, draw(), 1.0})
                if (draw() < 0.5) some.handles.push_back(handle(at, 500.0 * draw()));
            options.curves.push_back(some);
        }
        options.points.push_back(
            point("p", coordinate(), coordinate(), 90.0, 300.0 * draw()));
        survives([&] {
            const Made some(options);
            ++made;
            for (int level : {1, 5})
                for (const Pull& pull : some.geometry.pulls(whole(level)))
                    ASSERT_TRUE(std::isfinite(pull.target + pull.reach));
            for (const auto& site : some.geometry.sites())
                ASSERT_TRUE(std::isfinite(site.height)) << seed;
        });
    }
    EXPECT_GT(made, 10);
}

TEST(TextureGeometry, PathsOfADrawingByName) {
    const TemporaryFolder folder;
    Curve c = curve({}, 10.0);
    c.drawing = open_source(
        folder.with("a.svg",
                    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 50'>"
                    "<path id='a' d='M10 10H90M10 20H90'/><path d='M10 30H90'/></svg>"));
    EXPECT_EQ(Made(with({c})).geometry.names(),
              (std::vector<std::string>{"curve/a", "curve/a 2", "curve/path"}));
    c.id = "a";
    const Made made(with({c}));
    EXPECT_EQ(made.geometry.names().size(), 2u);
    // The page lies over the terrain, its top to the north.
    EXPECT_NEAR(pull_at(made.geometry, 1280, 1024, 0).distance, 1.0, 1e-3);
    c.id = "b";
    expect_error(ExitCode::kBadRequest, "no path has the id 'b'; there are a, a",
                 [&] { Made none(with({c})); });
    c.drawing = open_source(folder.with(
        "b.svg", "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'/>"));
    expect_error(ExitCode::kBadRequest, "nothing is drawn",
                 [&] { Made none(with({c})); });
}

}  // namespace
}  // namespace cydonia::texture
