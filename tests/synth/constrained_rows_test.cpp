#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "synth/pareidolia/constrained/light_rows.h"
#include "tests/synth/constrained_fields.h"

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

constexpr double kAzimuths[] = {0.0,   17.0,  35.0,  45.0,  80.0,  90.0,  107.0, 135.0,
                                170.0, 180.0, 200.0, 225.0, 260.0, 270.0, 305.0, 315.0};
constexpr Stops kBoth[] = {Stops::kColumns, Stops::kEveryEdge};

// Height of the mesh over (x, y): squares are split from their north-west corner to the
// south-east one.
double mesh_height(const Field<float>& heights, double x, double y) {
    const int i = std::clamp(static_cast<int>(x), 0, heights.width() - 2);
    const int j = std::clamp(static_cast<int>(y), 0, heights.height() - 2);
    const double u = x - i, v = y - j;
    const double nw = heights(i, j), ne = heights(i + 1, j);
    const double sw = heights(i, j + 1), se = heights(i + 1, j + 1);
    return u > v ? nw + u * (ne - nw) + v * (se - ne)
                 : nw + v * (sw - nw) + u * (se - sw);
}

double dot(const Field<float>& a, const Field<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(a[i]) * b[i];
    return sum;
}

bool on_grid(const LightRows& rows, int sample, int row) {
    const auto [first, past] = rows.span(row);
    return sample >= first && sample < past && rows.counts(sample);
}

// Random, around 1, where samples lie on the grid; 0 beyond.
Field<float> random_samples(const LightRows& rows, std::uint64_t seed) {
    Field<float> samples = random_field(rows.samples(), rows.rows(), seed);
    for (int row = 0; row < rows.rows(); ++row)
        for (int i = 0; i < rows.samples(); ++i)
            samples(i, row) = on_grid(rows, i, row) ? 1.0f + samples(i, row) : 0.0f;
    return samples;
}

double greatest_eigenvalue(const LightRows& rows, int width, int height) {
    Field<float> v = random_field(width, height, 5);
    for (float& x : v) x += 1.5f;  // near the flattest, which is the greatest
    double growth = 0.0;
    for (int i = 0; i < 200; ++i) {
        const double before = std::sqrt(dot(v, v));
        v = rows.gathered(rows.sampled(v));
        growth = std::sqrt(dot(v, v)) / before;
        for (float& x : v) x = static_cast<float>(x / (before * growth));
    }
    return growth;
}

}  // namespace

TEST(LightRows, APlaneIsSampledExactly) {
    for (const auto& [width, height] : {std::pair{40, 29}, {29, 40}, {17, 17}}) {
        Field<float> plane(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) plane(x, y) = float(3 * x - 2 * y);
        for (const double azimuth : kAzimuths)
            for (const Stops stops : kBoth) {
                const LightRows rows(width, height, radians(azimuth), stops);
                const Field<float> samples = rows.sampled(plane);
                int seen = 0;
                for (int row = 0; row < rows.rows(); ++row)
                    for (int i = rows.span(row).first; i < rows.span(row).past; ++i) {
                        if (!rows.counts(i)) continue;
                        const auto p = rows.position(rows.column(i), row);
                        ASSERT_NEAR(samples(i, row), 3.0 * p.x - 2.0 * p.y, 1e-3)
                            << azimuth << ", row " << row << ", sample " << i;
                        ++seen;
                    }
                // Rows leave out no more than the two corners that they cut.
                EXPECT_GE(seen, (width - 1) * (height - 1)) << azimuth;
            }
    }
}

TEST(LightRows, FollowTheLight) {
    for (const double azimuth : kAzimuths) {
        const LightRows rows(30, 20, radians(azimuth), Stops::kColumns);
        const auto from = rows.position(3.0, 2), to = rows.position(4.0, 2);
        EXPECT_NEAR(to.x - from.x, -std::sin(radians(azimuth)) * rows.step(), 1e-9);
        EXPECT_NEAR(to.y - from.y, std::cos(radians(azimuth)) * rows.step(), 1e-9);
    }
}

TEST(LightRows, SamplesComeInTheirOrder) {
    for (const double azimuth : kAzimuths)
        for (const Stops stops : kBoth) {
            const LightRows rows(31, 22, radians(azimuth), stops);
            for (int i = 1; i < rows.samples(); ++i)
                EXPECT_LE(rows.column(i - 1), rows.column(i) + 1e-6) << azimuth;
        }
}

TEST(LightRows, StayOnTheGrid) {
    for (const double azimuth : kAzimuths)
        for (const Stops stops : kBoth) {
            const LightRows rows(31, 22, radians(azimuth), stops);
            for (int row = 0; row < rows.rows(); ++row)
                for (int i = rows.span(row).first; i < rows.span(row).past; ++i) {
                    const auto p = rows.position(rows.column(i), row);
                    ASSERT_TRUE(p.x > -1e-6 && p.x < 30 + 1e-6 && p.y > -1e-6 &&
                                p.y < 21 + 1e-6)
                        << azimuth << ": " << p.x << ", " << p.y;
                }
        }
}

TEST(LightRows, EveryCellIsOnOneRowUnderASunOnAnAxis) {
    for (const double azimuth : {0.0, 90.0, 180.0, 270.0, 360.0})
        for (const Stops stops : kBoth) {
            const LightRows rows(23, 14, radians(azimuth), stops);
            Field<int> times(23, 14);
            for (int row = 0; row < rows.rows(); ++row)
                for (int i = rows.span(row).first; i < rows.span(row).past; ++i) {
                    const auto p = rows.position(rows.column(i), row);
                    ASSERT_EQ(p.x, std::round(p.x));
                    ASSERT_EQ(p.y, std::round(p.y));
                    ++times(static_cast<int>(p.x), static_cast<int>(p.y));
                }
            for (const int n : times) EXPECT_EQ(n, 1) << azimuth;
        }
}

// The profile of a row is that of the mesh: between its samples nothing bends.
TEST(LightRows, TheMeshIsStraightBetweenSamples) {
    for (const auto& [width, height] : {std::pair{24, 17}, {13, 30}}) {
        const Field<float> heights = random_field(width, height, 3, 10.0);
        for (const double azimuth : kAzimuths) {
            const LightRows rows(width, height, radians(azimuth), Stops::kEveryEdge);
            const Field<float> samples = rows.sampled(heights);
            int seen = 0;
            for (int row = 0; row < rows.rows(); ++row) {
                int before = -1;
                for (int i = rows.span(row).first; i < rows.span(row).past; ++i) {
                    if (!rows.counts(i)) continue;
                    for (int part = 0; before >= 0 && part <= 8; ++part) {
                        const double t = part / 8.0;
                        const double column =
                            (1.0 - t) * rows.column(before) + t * rows.column(i);
                        const auto p = rows.position(column, row);
                        ASSERT_NEAR(
                            (1.0 - t) * samples(before, row) + t * samples(i, row),
                            mesh_height(heights, p.x, p.y), 1e-3)
                            << azimuth << ": " << p.x << ", " << p.y;
                        ++seen;
                    }
                    before = i;
                }
            }
            EXPECT_GT(seen, width * height);
        }
    }
}

TEST(LightRows, GatheringIsTheTransposeOfSampling) {
    for (const double azimuth : kAzimuths)
        for (const Stops stops : kBoth) {
            const LightRows rows(26, 19, radians(azimuth), stops);
            double factor = 0.0;
            for (std::uint64_t seed = 0; seed < 6; ++seed) {
                Field<float> heights = random_field(26, 19, seed);
                for (float& h : heights) h += 1.0f;  // products far from 0
                const Field<float> samples = random_samples(rows, seed + 10);
                const double there = dot(rows.sampled(heights), samples);
                const double back = dot(heights, rows.gathered(samples));
                if (seed == 0) factor = back / there;
                EXPECT_NEAR(back, factor * there, 1e-5 * std::abs(back)) << azimuth;
            }
            EXPECT_GT(factor, 0.2) << azimuth;  // else the steps are needlessly short
            EXPECT_LE(factor, 1.0 + 1e-6) << azimuth;
        }
}

TEST(LightRows, NoEigenvalueIsAboveOne) {
    for (const double azimuth : kAzimuths)
        for (const Stops stops : kBoth) {
            const LightRows rows(40, 33, radians(azimuth), stops);
            EXPECT_LE(greatest_eigenvalue(rows, 40, 33), 1.0 + 1e-4)
                << azimuth << (stops == Stops::kColumns ? " columns" : " edges");
        }
}

TEST(LightRows, OfTheSmallestGrids) {
    for (const auto& [width, height] : {std::pair{2, 2}, {2, 9}, {9, 2}, {3, 3}})
        for (const double azimuth : kAzimuths)
            for (const Stops stops : kBoth) {
                const LightRows rows(width, height, radians(azimuth), stops);
                const Field<float> samples =
                    rows.sampled(Field<float>(width, height, 7.0f));
                for (int row = 0; row < rows.rows(); ++row)
                    for (int i = rows.span(row).first; i < rows.span(row).past; ++i)
                        if (rows.counts(i)) {
                            EXPECT_NEAR(samples(i, row), 7.0f, 1e-5);
                        }
            }
}
