#include "synth/distance/profile.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "field/image.h"
#include "synth/distance/curve.h"
#include "synth/distance/relief.h"
#include "tests/field/temporary_folder.h"

namespace cydonia::distance {
namespace {

using Points = std::vector<std::array<double, 2>>;

Profile listed(const Points& points) {
    Profile profile;
    profile.name = "test";
    profile.curve.points = points;
    return profile;
}

// Sea level at 600 m; 5120 m wide, so that a unit of x is 10 m.
Descent descent(const Profile& profile) {
    return descent_of(profile, 600.0, 1.0, 0.001, 5120.0);
}

std::vector<std::filesystem::path> shipped() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(CYDONIA_SOURCE_DIR) / "config/profiles")) {
        files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

// Every shipped profile unchanged, in layers, with detail, and with both.
std::vector<Profile> all_shapes() {
    std::vector<Profile> shapes;
    for (const auto& file : shipped()) {
        for (const int layers : {0, 9}) {
            for (const double detail : {0.0, 1.0}) {
                Profile profile;
                profile.name = file.stem();
                profile.curve.table = open_source(file);
                profile.strata = {.layers = layers, .hardness = 1.0};
                profile.detail = detail;
                shapes.push_back(profile);
            }
        }
    }
    return shapes;
}

std::string label(const Profile& profile) {
    return profile.name + (profile.strata.layers > 0 ? ", layers" : "") +
           (profile.detail > 0.0 ? ", detail" : "");
}

float distance_of(const Descent& descent, int i, int n) {
    return static_cast<float>(descent.reach * i / n);
}

bool same_bytes(const Descent& a, const Descent& b) {
    return a.knots.size() == b.knots.size() &&
           std::memcmp(a.knots.data(), b.knots.data(),
                       a.knots.size() * sizeof(Descent::Knot)) == 0;
}

TEST(Descent, OfAStraightProfileIsExact) {
    const Descent line = descent(listed({{0, 1}, {64, 0}}));
    EXPECT_EQ(line.reach, 640.0);
    EXPECT_EQ(line.sea_level, 600.0);
    for (int i = 0; i <= 3000; ++i) {  // beyond the reach as well
        const float distance = distance_of(line, i, 2000);
        ASSERT_FLOAT_EQ(line(distance), 0.9375f * distance);
        ASSERT_FLOAT_EQ(line.distance_at(0.9375f * distance), distance);
    }
}

TEST(Descent, PassesThroughItsPoints) {
    const Descent line = descent(listed({{0, 10}, {1, 6}, {3, 2}, {8, 0}}));
    EXPECT_FLOAT_EQ(line(0.0f), 0.0f);
    EXPECT_FLOAT_EQ(line(10.0f), 240.0f);
    EXPECT_FLOAT_EQ(line(20.0f), 360.0f);
    EXPECT_FLOAT_EQ(line(30.0f), 480.0f);
    EXPECT_FLOAT_EQ(line(80.0f), 600.0f);
    EXPECT_FLOAT_EQ(line(130.0f), 720.0f);
}

TEST(Descent, OfEveryShippedProfileRisesToSeaLevel) {
    ASSERT_GE(shipped().size(), 20u);
    for (const Profile& profile : all_shapes()) {
        SCOPED_TRACE(label(profile));
        const Descent line = descent(profile);
        EXPECT_EQ(line(0.0f), 0.0f);
        EXPECT_FLOAT_EQ(line(static_cast<float>(line.reach)), 600.0f);
        EXPECT_EQ(line.sea_level, 600.0);
        for (int i = 1; i <= 30000; ++i) {
            ASSERT_GE(line(distance_of(line, i, 20000)),
                      line(distance_of(line, i - 1, 20000)));
        }
        for (std::size_t i = 1; i < line.knots.size(); ++i) {
            ASSERT_GT(line.knots[i].cost, line.knots[i - 1].cost);
            ASSERT_GT(line.knots[i].distance, line.knots[i - 1].distance);
        }
    }
}

TEST(Descent, InverseOfEveryShippedProfile) {
    for (const Profile& profile : all_shapes()) {
        SCOPED_TRACE(label(profile));
        const Descent line = descent(profile);
        const auto reach = static_cast<float>(line.reach);
        EXPECT_EQ(line.distance_at(0.0f), 0.0f);
        float before = 0.0f;
        for (int i = 0; i <= 30000; ++i) {
            const float cost = 600.0f * static_cast<float>(i) / 20000.0f;
            const float distance = line.distance_at(cost);
            ASSERT_GE(distance, before);
            before = distance;
            // A float's step in distance is worth more cost where it is steep.
            const float share = std::min(cost / 600.0f, 1.0f);
            const float steps = 1e-6f * std::max(cost, 1.0f);
            const float low = line(distance * (1.0f - 4e-7f) - 1e-7f * reach);
            const float high = line(distance * (1.0f + 4e-7f) + 1e-7f * reach);
            ASSERT_LE(low, cost + steps) << share;
            ASSERT_GE(high, cost - steps) << share;
        }
    }
}

TEST(Descent, LeastSlopeIsNeverTooMuch) {
    for (const Profile& profile : all_shapes()) {
        SCOPED_TRACE(label(profile));
        const Descent line = descent(profile);
        for (int a = 0; a < 100; a += 3) {
            for (int b = a; b <= 110; b += b < a + 4 ? 1 : 13) {
                const float low = 0.01f * static_cast<float>(a);
                const float high = 0.01f * static_cast<float>(b);
                const float bound = line.least_slope(low, high);
                ASSERT_GT(bound, 0.0f);
                float least = 1e9f,
                      around = 1e9f;  // of the bins' whole width: a bound below
                for (std::size_t k = 0; k + 1 < line.knots.size(); ++k) {
                    const auto& knot = line.knots[k];
                    const float from = knot.cost / 600.0f,
                                to = line.knots[k + 1].cost / 600.0f;
                    if (to >= low && from <= std::min(high, 1.0f)) {
                        least = std::min(least, knot.slope);
                    }
                    if (to >= low - 0.003f && from <= high + 0.003f) {
                        around = std::min(around, knot.slope);
                    }
                }
                ASSERT_LE(bound, least) << low << " to " << high;
                ASSERT_GE(bound, 0.998f * around) << low << " to " << high;
            }
        }
    }
}

// By finite differences of operator() itself.
TEST(Descent, LeastSlopeBoundsEveryStep) {
    for (const Profile& profile : all_shapes()) {
        SCOPED_TRACE(label(profile));
        const Descent line = descent(profile);
        const float step = static_cast<float>(line.reach / 700.0);
        for (int i = 0; i < 2000; ++i) {
            const float a = distance_of(line, i, 1500), b = a + step;
            const float rise = line(b) - line(a);
            const float least = line.least_slope(line(a) / 600.0f, line(b) / 600.0f);
            ASSERT_GE(rise + 2e-4f, least * (b - a)) << "at " << a;
        }
    }
}

TEST(Profile, FlatPartsAreLeft) {
    Profile mesa = listed({{0, 9}, {5, 9}, {6, 1}, {12, 1}, {13, 0}});
    mesa.reach = metres(1300.0);
    const Descent line = descent_of(mesa, 90.0, 2.0, 0.001, 5120.0);
    for (int i = 1; i <= 1000; ++i) {
        ASSERT_GT(line(distance_of(line, i, 1000)), line(distance_of(line, i - 1, 1000)));
    }
    EXPECT_NEAR(line(600.0f), 80.0, 0.1);
}

TEST(Profile, TooFlatSlopesComeFromTheirNeighbours) {
    Profile profile = listed({{0, 100}, {10, 50}, {1000, 49.9}, {1010, 0}});
    profile.reach = metres(1010.0);
    const Descent line = descent_of(profile, 100.0, 2.0, 0.001, 5120.0);
    // All three pieces have slope 5 now: 100 m of cost in 20 m.
    EXPECT_NEAR(line.reach, 20.0, 0.05);
    EXPECT_NEAR(line(10.0f), 50.0, 0.1);
}

TEST(Profile, FlatToTheEnds) {
    // Nothing steep enough before or after; nothing steep enough at all.
    EXPECT_NEAR(descent(listed({{0, 1}, {1000, 0.9999}, {1010, 0}})).reach, 100.0, 1.0);
    EXPECT_NEAR(descent(listed({{0, 1}, {10, 0.0001}, {1000, 0}})).reach, 100.0, 1.0);
    EXPECT_NEAR(descent(listed({{0, 1}, {500000, 0.9}, {9000000, 0}})).reach, 600000.0,
                1.0);
}

// The ledges of a straight slope: runs of ground that are much less steep.
int ledges(const Descent& line, double slope) {
    int count = 0;
    bool on_ledge = false;
    for (int i = 1; i <= 4000; ++i) {
        const double rise =
            line(distance_of(line, i, 4000)) - line(distance_of(line, i - 1, 4000));
        const bool level = rise < 0.6 * slope * line.reach / 4000.0;
        count += level && !on_ledge;
        on_ledge = level;
    }
    return count;
}

TEST(Strata, AsManyLedgesAsLayers) {
    Profile profile = listed({{0, 1}, {60, 0}});
    EXPECT_EQ(ledges(descent(profile), 1.0), 0);
    for (const int layers : {1, 2, 7, 20, 64}) {
        for (const double hardness : {0.5, 1.0}) {
            profile.strata = {.layers = layers, .hardness = hardness};
            EXPECT_EQ(ledges(descent(profile), 1.0), layers) << hardness;
        }
    }
}

TEST(Strata, ACliffOverALedge) {
    Profile profile = listed({{0, 1}, {60, 0}});
    profile.strata = {.layers = 3, .hardness = 1.0};
    const Descent line = descent(profile);
    EXPECT_EQ(line.reach, 600.0);
    // Layers of 200 m of cost: down within 20 m of way, then nearly level.
    for (int layer = 0; layer < 3; ++layer) {
        const float top = 200.0f * static_cast<float>(layer);
        EXPECT_NEAR(line(top), top, 0.01);
        EXPECT_GT(line(top + 20.0f), top + 195.0f);
        EXPECT_LT(line(top + 199.0f), top + 200.0f);
    }
}

TEST(Strata, HardnessIsHowDeepTheyAreCut) {
    Profile profile = listed({{0, 1}, {60, 0}});
    double before = 0.0;
    for (const double hardness : {0.25, 0.5, 0.75, 1.0}) {
        profile.strata = {.layers = 5, .hardness = hardness};
        const Descent line = descent(profile);
        double deepest = 0.0;  // below the slope as drawn
        for (int i = 0; i <= 600; ++i) {
            deepest = std::max(deepest, 1.0 * line(static_cast<float>(i)) - i);
        }
        EXPECT_GT(deepest, before + 10.0);
        before = deepest;
    }
}

TEST(Strata, OfHardnessZeroAreNone) {
    for (const auto& file : shipped()) {
        Profile profile;
        profile.curve.table = open_source(file);
        const Descent none = descent(profile);
        profile.strata = {.layers = 12, .hardness = 0.0};
        EXPECT_TRUE(same_bytes(descent(profile), none)) << file;
        profile.strata = {.layers = 0, .hardness = 1.0};
        EXPECT_TRUE(same_bytes(descent(profile), none)) << file;
    }
}

TEST(Strata, KeepEndsAndReach) {
    for (Profile profile : all_shapes()) {
        const Descent cut = descent(profile);
        profile.strata.layers = 0;
        profile.detail = 0.0;
        const Descent drawn = descent(profile);
        EXPECT_EQ(cut.reach, drawn.reach) << label(profile);
        EXPECT_EQ(cut.sea_level, drawn.sea_level) << label(profile);
    }
}

// Of a straight slope, over steps of 10 m.
std::vector<double> slopes_with(double detail, const std::string& name,
                                double units = 90) {
    Profile profile = listed({{0, 1}, {units, 0}});
    profile.name = name;
    profile.detail = detail;
    const Descent line = descent_of(profile, 10.0 * units, 1.0, 0.001, 5120.0);
    std::vector<double> slopes;
    for (float x = 0.0f; x < static_cast<float>(line.reach); x += 10.0f) {
        slopes.push_back((line(x + 10.0f) - line(x)) / 10.0f);
    }
    return slopes;
}

TEST(Detail, VariesTheSlopeAsMuchAsItSays) {
    for (const double slope : slopes_with(0.0, "a")) ASSERT_NEAR(slope, 1.0, 1e-4);
    double before = 0.0;
    for (const double detail : {0.25, 0.5, 1.0}) {
        const std::vector<double> slopes = slopes_with(detail, "a", 900);
        double squares = 0.0;
        for (const double slope : slopes) {
            ASSERT_GT(slope, 0.0);
            squares += (slope - 1.0) * (slope - 1.0);
        }
        const double deviation = std::sqrt(squares / static_cast<double>(slopes.size()));
        EXPECT_GT(deviation, before + 0.05);
        EXPECT_LT(deviation, detail);
        before = deviation;
    }
}

TEST(Detail, IsOfTheProfilesNameAndOfMetres) {
    EXPECT_EQ(slopes_with(0.5, "a"), slopes_with(0.5, "a"));
    EXPECT_NE(slopes_with(0.5, "a"), slopes_with(0.5, "b"));
    // The same waves at the same places of a longer slope, which may lean otherwise.
    const std::vector<double> near = slopes_with(0.5, "a", 90);
    const std::vector<double> far = slopes_with(0.5, "a", 180);
    for (std::size_t i = 2; i < 88; ++i) {
        EXPECT_NEAR(near[i] / near[i - 1], far[i] / far[i - 1], 0.05);
    }
}

TEST(Detail, NeverLevelAndNoJump) {
    for (const double cost : {60.0, 600.0, 6000.0}) {
        const std::vector<CostPoint> line{{0.0, 0.0}, {900.0, cost}};
        const double slope = cost / 900.0;
        double least = 9.0, most = 0.0;  // times the slope
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const std::vector<CostPoint> cut = with_detail(line, 1.0, 160.0, seed);
            EXPECT_EQ(cut.back().cost, cost);
            EXPECT_EQ(cut.back().distance, 900.0);
            for (std::size_t i = 1; i < cut.size(); ++i) {
                const double step = (cut[i].cost - cut[i - 1].cost) /
                                    (cut[i].distance - cut[i - 1].distance) / slope;
                least = std::min(least, step);
                most = std::max(most, step);
            }
        }
        EXPECT_GT(least, 0.02);
        EXPECT_LT(least, 0.3);
        EXPECT_GT(most, 1.6);
        EXPECT_LT(most, 3.0);
    }
}

TEST(Detail, OfACliffDoesNotTipTheLand) {
    // What is above and below keeps its height, about.
    Profile profile = listed({{0, 1}, {40, 0.9}, {41, 0.1}, {80, 0}});
    const Descent drawn = descent(profile);
    profile.detail = 1.0;
    const Descent cut = descent(profile);
    for (int i = 0; i <= 80; ++i) {
        const float x = 10.0f * static_cast<float>(i);
        if (i == 40 || i == 41) continue;
        EXPECT_NEAR(cut(x), drawn(x), 60.0) << x;
    }
}

TEST(Curve, OfATable) {
    const TemporaryFolder folder;
    Curve curve;
    curve.table = open_source(folder.with(
        "a.csv", "# a comment\r\n0, 1\r\n\r\n  1.5e0 ,0.5 # the knee\r\n+4,-2"));
    // No sign before a number.
    expect_error(ExitCode::kBadRequest, "a.csv:5: expected two numbers",
                 [&] { points_of(curve, "profile a"); });
    curve.table = open_source(
        folder.with("a.csv", "\xef\xbb\xbf# \n0, 1\r\n\r\n 1.5e0\t,.5#\n4,-2"));
    const std::vector<CurvePoint> points = points_of(curve, "profile a");
    ASSERT_EQ(points.size(), 3u);
    EXPECT_EQ(points[1].x, 1.5);
    EXPECT_EQ(points[1].f, 0.5);
    EXPECT_EQ(points[2].f, -2.0);
}

TEST(Curve, OfATableWithAFlaw) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& text, std::string_view words) {
        Curve curve;
        curve.table = open_source(folder.with("a.csv", text));
        expect_error(ExitCode::kBadRequest, words,
                     [&] { falling_points_of(curve, "profile a"); });
    };
    refused("#", "at least two points x, f(x) are needed, 0 found");
    refused("0, 1\n", "at least two points x, f(x) are needed, 1 found");
    refused("x, f(x)\n0, 1\n1, 0\n", "a.csv:1: expected two numbers");
    refused("0, 1\n1; 0\n", "a.csv:2: expected two numbers");
    refused("0, 1\n1, 0, 3\n", "a.csv:2: expected two numbers");
    refused("0, 1\n1,\n", "a.csv:2: expected two numbers");
    refused("0, 1\n1 0\n", "a.csv:2: expected two numbers");
    refused(std::string("0, 1\n1, \0 0\n", 12), "a.csv:2: expected two numbers");
    refused("0, 1\n1, nan\n", "a.csv:2: the number is not finite or too large");
    refused("0, 1\ninf, 0\n", "a.csv:2: the number is not finite or too large");
    refused("0, 1\n1, -1e300\n", "a.csv:2: the number is not finite or too large");
    refused("0, 1\n1, 1e999\n", "a.csv:2: expected two numbers");
    refused("0, 1\n\n1, 0.5\n0.5, 0\n", "a.csv:4: x must increase, but 0.5 follows 1");
    refused("0, 1\n1, 0.5\n# up\n2, 0.7\n3, 0\n",
            "a.csv:4: rises, but a cross-section must fall from the feature outward");
    refused("0, 1\n1, 1\n", "a.csv is flat");
    refused("\x89PNG\r\n\x1a\n", "a.csv:1: expected two numbers");
    std::string lines;
    for (int i = 0; i <= 4096; ++i) lines += std::to_string(i) + ", 0\n";
    refused(lines, "more than 4096 lines");
    refused(std::string(2u << 20, '0'), "is larger than");
}

TEST(Curve, OfPointsWithAFlaw) {
    const auto refused = [](const Points& points, std::string_view words) {
        expect_error(ExitCode::kBadRequest, words, [&] { descent(listed(points)); });
    };
    refused({}, "profile test: at least two points");
    refused({{0, 1}}, "profile test: at least two points");
    refused({{0, 10}, {4, 5}, {7, 6}, {9, 0}}, "profile test at x = 7: rises");
    refused({{0, 1}, {4, 1}}, "profile test is flat");
    refused({{0, 1}, {0, 0}}, "x must increase");
    refused({{0, 1}, {NAN, 0}}, "not finite or too large");
    refused({{0, 1}, {1, NAN}}, "not finite or too large");
    refused({{0, 1}, {1e308, 0}}, "not finite or too large");
}

class Picture {
  public:
    explicit Picture(const Field<std::uint8_t>& grey) {
        write_png(folder_ / "drawn.png", grey);
    }
    explicit Picture(const std::string& svg) { folder_.with("drawn.png", svg); }
    Curve curve() const {
        Curve curve;
        curve.image = open_source(folder_ / "drawn.png");
        return curve;
    }

  private:
    TemporaryFolder folder_;
};

TEST(Curve, OfAPictureIsTheMiddleOfItsLine) {
    Field<std::uint8_t> pixels(40, 30, 255);
    for (int x = 3; x < 37; ++x) {
        if (x == 20) continue;  // a gap is bridged
        for (int y = x / 2; y < x / 2 + 5; ++y) pixels(x, y) = 0;
    }
    const std::vector<CurvePoint> points = points_of(Picture(pixels).curve(), "");
    ASSERT_EQ(points.size(), 33u);
    EXPECT_EQ(points.front().x, 3.0);
    for (const CurvePoint& point : points) {
        EXPECT_NEAR(point.f, -std::floor(point.x / 2) - 2.0, 1e-9);
    }
}

TEST(Curve, OfADrawingIsFinerThanItsPixels) {
    const Picture picture(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 512 512'>"
        "<path d='M0 100 L512 151.2' stroke='#222' stroke-width='3' fill='none'/></svg>");
    const std::vector<CurvePoint> points = points_of(picture.curve(), "");
    for (std::size_t i = 2; i + 2 < points.size(); ++i) {
        EXPECT_NEAR(points[i].f, -99.5 - 0.1 * (points[i].x + 0.5), 0.15) << points[i].x;
    }
}

TEST(Curve, OfADrawingLeavesOutTheCornersOfItsEnds) {
    for (const char* cap : {"butt", "round", "square"}) {
        for (const int width : {2, 4, 8}) {
            const Picture picture(fmt::format(
                "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 512 512'>"
                "<path d='M20 10 L200 400' stroke='black' stroke-width='{}' "
                "stroke-linecap='{}' fill='none'/></svg>",
                width, cap));
            const auto points = falling_points_of(picture.curve(), "profile a");
            EXPECT_NEAR(points.front().x, 20.0, 4.0) << cap << width;
            EXPECT_NEAR(points.front().f, -10.0, 4.0) << cap << width;
            EXPECT_NEAR(points.back().x, 200.0, 4.0) << cap << width;
            EXPECT_NEAR(points.back().f, -400.0, 4.0) << cap << width;
        }
    }
}

TEST(Curve, OfAPictureWithAFlaw) {
    const auto refused = [](const Field<std::uint8_t>& pixels, std::string_view words) {
        const Picture picture(pixels);
        expect_error(ExitCode::kBadRequest, words,
                     [&] { falling_points_of(picture.curve(), "profile a"); });
    };
    Field<std::uint8_t> pixels(8, 8, 255);
    refused(pixels, "0 found");
    pixels(3, 3) = 0;
    refused(pixels, "drawn.png: a dark line over at least two columns");
    for (int x = 0; x < 8; ++x) pixels(x, 3) = 0;
    refused(pixels, "is flat");
    pixels = Field<std::uint8_t>(8, 8, 255);
    for (int x = 0; x < 6; ++x) pixels(x, x) = 0;
    pixels(6, 3) = 0;
    refused(pixels, "at x = 6 pixels: rises");
    refused(Field<std::uint8_t>(1, 1, 0), "at least two columns");
    refused(Field<std::uint8_t>(8, 1, 0), "is flat");
}

TEST(Curve, OfAPictureMayWaverByAPixel) {
    Field<std::uint8_t> pixels(8, 8, 255);
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 2}, {2, 1}, {3, 3}, {4, 6}}) {
        pixels(x, y) = 0;
    }
    const auto points = falling_points_of(Picture(pixels).curve(), "profile a");
    EXPECT_EQ(points[2].f, -2.0);
    EXPECT_EQ(points[4].f, -6.0);
}

TEST(Curve, StretchedToOne) {
    Curve curve;
    curve.points = {{10, 3}, {15, 7}, {20, 5}};
    const std::vector<CurvePoint> points = unit_points_of(curve, "heights");
    ASSERT_EQ(points.size(), 3u);
    EXPECT_EQ(points[0].x, 0.0);
    EXPECT_EQ(points[0].f, 0.0);
    EXPECT_EQ(points[1].x, 0.5);
    EXPECT_EQ(points[1].f, 1.0);
    EXPECT_EQ(points[2].x, 1.0);
    EXPECT_EQ(points[2].f, 0.5);
    curve.points = {{0, 4}, {1, 4}};
    for (const CurvePoint& point : unit_points_of(curve, "")) EXPECT_EQ(point.f, 1.0);
}

TEST(Profile, WithCarvingOutOfRange) {
    const auto refused = [](auto change, std::string_view words) {
        Profile profile = listed({{0, 1}, {60, 0}});
        change(profile);
        expect_error(ExitCode::kBadRequest, words, [&] { descent(profile); });
    };
    refused([](Profile& p) { p.strata.layers = -1; }, "strata.layers is -1");
    refused([](Profile& p) { p.strata.layers = 65; }, "strata.layers is 65");
    refused([](Profile& p) { p.strata.hardness = 1.1; }, "strata.hardness is 1.1");
    refused([](Profile& p) { p.detail = -0.1; }, "detail is -0.1");
    refused([](Profile& p) { p.detail = NAN; }, "detail is nan");
    refused([](Profile& p) { p.reach = metres(0.0); }, "reach is 0");
}

}  // namespace
}  // namespace cydonia::distance
