#include "synth/texture/database/matches.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "field/random.h"
#include "synth/texture/database/kd_tree.h"
#include "synth/texture/database/neighbourhood.h"
#include "tests/synth/texture_lands.h"

namespace cydonia::texture {
namespace {

LevelArrays matched(const std::vector<Land>& lands, int orientations,
                    const LevelArrays* coarser = nullptr) {
    LevelArrays level = level_of(lands);
    SilentProgress silent;
    add_matches(level, coarser, orientations, silent, 0.0, 1.0);
    return level;
}

template <class Visit>
void each_cell(const LevelArrays& level, const Visit& visit) {
    for (int e = 0; e < static_cast<int>(level.sheets.size()); ++e)
        for (int y = 0; y < level.sheets[std::size_t(e)].height; ++y)
            for (int x = 0; x < level.sheets[std::size_t(e)].width; ++x)
                visit(e, x, y, level.matches[level.sheets[std::size_t(e)].index(x, y)]);
}

// By the definition: turned cells beside cells, the height that fits best taken away.
double plain_unlikeness(const LevelArrays& level, int exemplar, int x, int y,
                        const Match& m) {
    const Sheet& here = level.sheets[std::size_t(exemplar)];
    const Sheet& there = level.sheets[m.exemplar];
    double squares = 0.0, sum = 0.0;
    for (const Step s : kCompared) {
        const Step r = turned(m.orientation, s);
        const Appearance a = level.appearance[here.index(x + s.x, y + s.y)];
        const Appearance b =
            turned_appearance(level.appearance[there.index(m.x + r.x, m.y + r.y)],
                              m.orientation, level.last_sign);
        for (std::size_t mode = 0; mode < 4; ++mode)
            squares += std::pow(a[mode] - b[mode], 2);
        sum += a[0] - b[0];
    }
    return (squares - sum * sum / 5.0) / 5.0;
}

void expect_allowed(const LevelArrays& level, const std::set<int>& orientations) {
    each_cell(level, [&](int e, int x, int y, const Match& m) {
        const Sheet& sheet = level.sheets[m.exemplar];
        ASSERT_LT(m.x, sheet.width);
        ASSERT_LT(m.y, sheet.height);
        ASSERT_NE(level.types[sheet.index(m.x, m.y)], kNowhere) << x << ' ' << y;
        ASSERT_TRUE(orientations.contains(m.orientation));
        if (m.exemplar == e) {
            ASSERT_GT(std::hypot(m.x - x, m.y - y), 5.0) << x << ' ' << y;
        }
    });
}

TEST(Matches, UnlikenessIsTurnedAndRaised) {
    const LevelArrays level =
        level_of({land_of(rough(60, 50)), land_of(rough(40, 60, 2))});
    for (int o = 0; o < 8; ++o)
        for (int i = 0; i < 20; ++i) {
            const Match m{static_cast<std::uint16_t>(5 + i),
                          static_cast<std::uint16_t>(50 - 2 * i), 1,
                          static_cast<std::uint8_t>(o)};
            const double truth = plain_unlikeness(level, 0, 10 + 2 * i, 30 - i, m);
            EXPECT_NEAR(dissimilarity(level, 0, 10 + 2 * i, 30 - i, m), truth,
                        1e-4 * truth + 1.0);
        }
}

TEST(Matches, SmallLevelsHaveTheBestOfAll) {
    const LevelArrays level =
        matched({land_of(rough(40, 30)), land_of(rough(24, 20, 2))}, 2);
    expect_allowed(level, {0, 2});
    each_cell(level, [&](int e, int x, int y, const Match& m) {
        EXPECT_EQ(dissimilarity(level, e, x, y, m), best_unlikeness(level, e, x, y, 2));
    });
}

TEST(Matches, LargerOnesAreNearTheBest) {
    const std::vector<Land> lands{land_of(rough(220, 160)), land_of(rough(90, 110, 2))};
    for (const int orientations : {1, 4}) {
        const LevelArrays level = matched(lands, orientations);
        expect_allowed(level, orientations == 1 ? std::set{0} : std::set{0, 1, 2, 3});
        double found = 0.0, best = 0.0;
        for (int i = 0; i < 150; ++i) {
            const int x = 37 * i % 220, y = 53 * i % 160;
            const Match m = level.matches[level.sheets[0].index(x, y)];
            found += std::sqrt(dissimilarity(level, 0, x, y, m));
            best += std::sqrt(best_unlikeness(level, 0, x, y, orientations));
        }
        EXPECT_LT(found, 1.065 * best) << orientations;
    }
}

TEST(Matches, RaisedCopyIsFound) {
    const Field<float> land = rough(150, 150);
    Field<float> raised = land;
    for (float& height : raised) height += 400.0f;
    const LevelArrays level = matched({land_of(land), land_of(raised)}, 1);
    int same = 0;
    for (int y = 3; y < 147; ++y)
        for (int x = 3; x < 147; ++x)
            same +=
                level.matches[level.sheets[0].index(x, y)] ==
                Match{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 1, 0};
    EXPECT_GT(same, 0.99 * 144 * 144);
}

TEST(Matches, TurnedCopyIsFoundAndHowItIsTurned) {
    const Field<float> land = rough(100, 80);
    for (const int o : {1, 3, 6, 7}) {
        const Field<float> copy = turned_land(land, o);
        const LevelArrays level = matched({land_of(copy), land_of(land)}, 8);
        int found = 0, places = 0;
        for (int y = 5; y < copy.height() - 5; ++y)
            for (int x = 5; x < copy.width() - 5; ++x, ++places) {
                const Step halves =
                    turned(o, {2 * x + 1 - copy.width(), 2 * y + 1 - copy.height()});
                found += level.matches[level.sheets[0].index(x, y)] ==
                         Match{static_cast<std::uint16_t>((halves.x + 99) / 2),
                               static_cast<std::uint16_t>((halves.y + 79) / 2), 1,
                               static_cast<std::uint8_t>(o)};
            }
        EXPECT_GT(found, 0.98 * places) << "orientation " << o;
    }
}

TEST(Matches, NothingFromVoids) {
    Land land = land_of(rough(160, 160));
    land.voids = Field<std::uint8_t>(160, 160);
    for (int y = 0; y < 160; ++y)
        for (int x = 60; x < 100; ++x) land.voids(x, y) = 1;
    expect_allowed(matched({land}, 1), {0});
}

TEST(Matches, SameForAnyNumberOfThreads) {
    const std::vector<Land> lands{land_of(rough(150, 130)), land_of(rough(90, 110, 2))};
    std::vector<LevelArrays> made;
    for (const std::size_t threads : {1u, 2u, 7u}) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                          threads);
        made.push_back(matched(lands, 8));
    }
    EXPECT_EQ(made[0].matches, made[1].matches);
    EXPECT_EQ(made[0].matches, made[2].matches);
}

TEST(Matches, CoarserOnesLeadTheWay) {
    // The same every 16 cells and however it is turned: of all the perfect matches the
    // one that the coarser level leads to is taken.
    const auto height = [](int x, int y) {
        const int u = std::min((x & 15), 15 - (x & 15)),
                  v = std::min((y & 15), 15 - (y & 15));
        return 10.0 * u * v + 3.0 * (u + v) * (u + v);
    };
    auto pyramid = pyramid_of({land_of(heights_of(128, 128, height))}, 2);
    for (LevelArrays& level : pyramid) add_appearance(level, modes_of(level), kScale);
    const Sheet& fine = pyramid[0].sheets[0];
    const Sheet& coarse = pyramid[1].sheets[0];
    for (const int o : {0, 1, 2, 3}) {
        // Turned about the middle of the exemplar and moved by 32 fine cells.
        const auto laid = [&](int x, int y, int size, int moved) {
            const Step halves = turned(o, {2 * x + 1 - size, 2 * y + 1 - size});
            return Match{static_cast<std::uint16_t>((halves.x + size - 1) / 2 + moved),
                         static_cast<std::uint16_t>((halves.y + size - 1) / 2), 0,
                         static_cast<std::uint8_t>(o)};
        };
        pyramid[1].matches.assign(pyramid[1].heights.size(), {});
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                pyramid[1].matches[coarse.index(x, y)] = laid(x, y, 64, 16);
        SilentProgress silent;
        add_matches(pyramid[0], &pyramid[1], 4, silent, 0.0, 1.0);
        for (int y = 8; y < 120; ++y)
            for (int x = 8; x < 120; ++x) {
                const Match m = laid(x, y, 128, 32);
                if (m.x >= 120 || std::hypot(m.x - x, m.y - y) <= 5.0) continue;
                ASSERT_EQ(pyramid[0].matches[fine.index(x, y)], m) << x << ' ' << y;
            }
    }
}

TEST(Matches, TinyLevelTakesTheFarthest) {
    const LevelArrays level = matched({land_of(rough(11, 11))}, 1);
    each_cell(level, [&](int, int x, int y, const Match& m) {
        EXPECT_NE(level.types[level.sheets[0].index(m.x, m.y)], kNowhere);
        if (x == 5 && y == 5) {
            EXPECT_NEAR(std::hypot(m.x - x, m.y - y), std::hypot(2, 2), 1e-9);
        }
    });
}

TEST(Matches, GuardRepeatsTheBorder) {
    const LevelArrays level = matched({land_of(rough(30, 20))}, 1);
    const Sheet& sheet = level.sheets[0];
    EXPECT_EQ(level.matches[sheet.index(-6, -6)], level.matches[sheet.index(0, 0)]);
    EXPECT_EQ(level.matches[sheet.index(35, 7)], level.matches[sheet.index(29, 7)]);
}

TEST(Matches, InterruptedAtOnce) {
    LevelArrays level = level_of({land_of(rough(100, 100))});
    Listener listener;
    listener.interrupt_at = 1;
    EXPECT_THROW(add_matches(level, nullptr, 1, listener, 0.0, 1.0), Interrupted);
}

TEST(KdTree, LeadsSamplesToTheirOwnLeaf) {
    std::vector<Sample> samples(5000);
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
        samples[i] = {{}, i, 0, 0};
        for (std::uint32_t k = 0; k < kTraits; ++k)
            samples[i].traits[k] = float(unit(mix(i * kTraits + k)));
    }
    const KdTree tree(samples);
    for (const Sample& sample : samples) {
        const auto leaf = tree.around(sample.traits);
        EXPECT_LE(leaf.size(), 24u);
        EXPECT_TRUE(std::ranges::any_of(
            leaf, [&](const Sample& s) { return s.exemplar == sample.exemplar; }));
    }
    EXPECT_TRUE(KdTree({}).around({}).empty());
}

}  // namespace
}  // namespace cydonia::texture
