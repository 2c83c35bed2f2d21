#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "synth/genetic/evolution/base.h"
#include "synth/genetic/evolution/height_field.h"
#include "synth/genetic/genetic.h"
#include "tests/synth/texture_lands.h"

namespace cydonia::genetic {
namespace {

using texture::Listener;
using texture::rough;

// Rough hills and a calm plain below them, in files; a map of a west and an east half.
class Evolution : public testing::Test {
  protected:
    Evolution() {
        for (int i = 0; i < 2; ++i) {
            Field<float> hills = rough(160, 160, std::uint64_t(i) + 3);
            for (float& h : hills) h += 600.0f;
            Field<float> plain = rough(160, 160, std::uint64_t(i) + 11);
            for (float& h : plain) h = 100.0f + 0.05f * h;
            add("hills", "hills" + std::to_string(i) + ".tif", hills);
            add("plain", "plain" + std::to_string(i) + ".tif", plain);
        }
        options_.map.regions = {
            {"west", "plain", {{{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}}},
            {"east", "hills", {{{0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}}}}};
        options_.evolution.population = 6, options_.evolution.cycles = 4;
    }

    void add(const std::string& type, const std::string& name,
             const Field<float>& heights, double spacing = 30.0) {
        auto found = std::ranges::find(options_.library.types, type, &TypeOptions::name);
        if (found == options_.library.types.end()) {
            options_.library.types.push_back({type, {}, {}});
            found = options_.library.types.end() - 1;
        }
        found->examples.push_back(
            {texture::exemplar_of(folder_, name, heights, spacing).source});
    }

    Terrain made(std::uint64_t seed = 1, int samples = 120, double spacing = 30.0) {
        Terrain flat;
        flat.spacing = spacing, flat.heights = Field<float>(samples, samples);
        Context context;
        context.seed = seed, context.progress = &listener_;
        return run(options_, flat, context);
    }
    std::string refused() {
        try {
            made();
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }

    std::vector<LevelSamples> samples(int levels, double spacing = 30.0) {
        return samples_of(options_.library,
                          std::vector<std::uint8_t>(options_.library.types.size(), 1),
                          spacing, 3, levels, listener_);
    }

    const TemporaryFolder folder_;
    Options options_;
    Listener listener_;
};

double deviation_of_slope(const Field<float>& h, int x0, int x1) {
    double sum = 0.0;
    int count = 0;
    for (int y = 1; y < h.height(); ++y)
        for (int x = x0; x < x1; ++x, ++count) {
            const double d = h(x, y) - h(x, y - 1);
            sum += d * d;
        }
    return std::sqrt(sum / count);
}

TEST(Gene, GoesOnWithTheSameLandWhicheverWayItIsTurned) {
    const Field<float> land = rough(90, 80);
    for (int turn = 0; turn < kTurns; ++turn) {
        const Gene gene{.sample = 0, .x = 30, .y = 27, .turn = std::uint8_t(turn)};
        const Gene next = continued(gene, 16, 1, 11, 5, 16);
        const Layout a = layout_of(gene, 16, 90), b = layout_of(next, 16, 90);
        // Cell (x + 11, y + 5) of the gene is cell (x, y) of the next.
        for (int y = 0; y < 11; ++y)
            for (int x = 0; x < 5; ++x)
                EXPECT_EQ(land.data()[a.start + (x + 11) * a.east + (y + 5) * a.south],
                          land.data()[b.start + x * b.east + y * b.south])
                    << turn;
    }
    // Three times as fine: the middle cell of each coarse one.
    for (int turn = 0; turn < kTurns; ++turn) {
        const Gene gene{.sample = 0, .x = 3, .y = 5, .turn = std::uint8_t(turn)};
        const Gene fine = continued(gene, 8, 3, 6, 9, 12);
        const Layout a = layout_of(gene, 8, 30), b = layout_of(fine, 12, 90);
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) {
                const std::ptrdiff_t coarse =
                    a.start + (x + 2) * a.east + (y + 3) * a.south;
                const std::ptrdiff_t at =
                    b.start + (3 * x + 1) * b.east + (3 * y + 1) * b.south;
                EXPECT_EQ(at % 90 / 3, coarse % 30) << turn;
                EXPECT_EQ(at / 90 / 3, coarse / 30) << turn;
            }
    }
}

TEST_F(Evolution, LevelsOfASampleNest) {
    const auto levels = samples(3);
    for (std::size_t level = 1; level < 3; ++level)
        for (std::size_t s = 0; s < levels[level].all.size(); ++s) {
            const SampleLand& fine = *levels[level].all[s].land;
            const SampleLand& coarse = *levels[level - 1].all[s].land;
            const Field<float> means = coarser(fine.heights, 3);
            const Field<float> up =
                finer(coarse.heights, 3, fine.heights.width(), fine.heights.height());
            for (std::size_t i = 0; i < means.size(); ++i)
                ASSERT_FLOAT_EQ(means[i], coarse.heights[i]);
            for (std::size_t i = 0; i < up.size(); ++i)
                ASSERT_NEAR(up[i] + fine.detail[i], fine.heights[i], 1e-3);
            EXPECT_NEAR(fine.mean(4, 6, 3, 2),
                        (fine.heights(4, 6) + fine.heights(5, 6) + fine.heights(6, 6) +
                         fine.heights(4, 7) + fine.heights(5, 7) + fine.heights(6, 7)) /
                            6.0,
                        1e-3);
        }
}

TEST_F(Evolution, ModelsAreReadSmallerWhereLevelsAreFinerThanThey) {
    const auto levels = samples(4, 10.0);
    EXPECT_FALSE(levels[2].all[0].smaller);
    const Sample& finest = levels[3].all[0];
    EXPECT_TRUE(finest.smaller);
    EXPECT_EQ(finest.land, levels[2].all[0].land);
    EXPECT_GT(finest.gain, 0.15f);
    EXPECT_LT(finest.gain, 0.55f);
}

// Genes that all go on with the first are the sample, to the bit: the encoding is
// lossless (section IV.3.3.4).
TEST_F(Evolution, AChromosomeHoldsASampleExactly) {
    const auto levels = samples(2);
    const GeneGrid grid = grid_of(Field<std::uint8_t>(100, 90, 0), 16, 5);
    Chromosome c(grid, levels[1]);
    const int example = levels[1].of_type[0][0];
    for (std::size_t slot = 0; slot < grid.slots.size(); ++slot) {
        const auto& s = grid.slots[slot];
        c.put(int(slot), {example, 20 + 11 * s.column, 25 + 11 * s.row});
    }
    for (std::size_t slot = 0; slot < grid.slots.size(); ++slot) {
        c.cut(int(slot));
        EXPECT_LE(c.seam(int(slot), false), 0.0f);
        EXPECT_LE(c.seam(int(slot), true), 0.0f);
    }
    std::vector<float> values(100 * 90);
    c.detail(0, 0, 100, 90, values.data());
    const Field<float>& detail = levels[1].all[std::size_t(example)].land->detail;
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 100; ++x)
            ASSERT_NEAR(values[std::size_t(y * 100 + x)], detail(20 + x, 25 + y), 1e-4);
    // Any part is that part of the whole.
    std::vector<float> part(13 * 9);
    c.detail(40, 31, 13, 9, part.data());
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 13; ++x)
            ASSERT_EQ(part[std::size_t(y * 13 + x)],
                      values[std::size_t((31 + y) * 100 + 40 + x)]);
}

Regions halves(int side) {
    Regions regions{Field<int>(side, side), {0, 1}, {0, 0}};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            ++regions.cells[std::size_t(regions.at(x, y) = x >= side / 2)];
    return regions;
}

// What a mutation changes is counted for its gene alone: sums that were carried along for
// all cycles are those of the field that came out.
TEST_F(Evolution, IncrementalFitnessIsTheWholeFields) {
    const auto levels = samples(2);
    const Regions regions = halves(100);
    Field<std::uint8_t> types(100, 100);
    std::ranges::transform(regions.at, types.begin(),
                           [](int r) { return std::uint8_t(r); });
    const GeneGrid grid = grid_of(types, 16, 5);
    const Field<float> pattern = finer(coarser(rough(100, 100, 5), 3), 3, 100, 100);
    const Fitness fitness(grid, levels[1], pattern, regions, Fitness::Follows::kShape,
                          0.5);
    const Evolved result =
        evolved(fitness, std::vector<std::optional<Gene>>(grid.slots.size()),
                options_.evolution, 9, listener_);
    std::vector<Fitness::Sums> sums(2);
    double compatible = 0.0;
    for (int block = 0; block < fitness.blocks(); ++block)
        sums[std::size_t(fitness.region_of(block))].add(fitness.sums(result.best, block),
                                                        1.0);
    for (int slot = 0; slot < int(grid.slots.size()); ++slot)
        compatible += fitness.compatibility(result.best, slot).all();
    const Generation& last = result.generations.back();
    EXPECT_NEAR(last.similarity,
                fitness.similarity(std::vector<double>{fitness.similarity(0, sums[0]),
                                                       fitness.similarity(1, sums[1])}),
                1e-6);
    EXPECT_NEAR(last.compatibility, compatible / double(grid.slots.size()), 1e-9);
    EXPECT_NEAR(last.fitness, 0.5 * last.compatibility + 0.5 * last.similarity, 1e-9);
    // And it has become fitter, cycle by cycle.
    ASSERT_EQ(result.generations.size(), 5u);
    for (std::size_t i = 1; i < 5; ++i)
        EXPECT_GE(result.generations[i].fitness, result.generations[i - 1].fitness);
    EXPECT_GT(last.fitness, result.generations.front().fitness + 0.01);
}

TEST_F(Evolution, TheBaseHasNoCliffs) {
    const auto levels = samples(2);
    const Regions regions = halves(40);
    const Base base = base_of(levels[0], regions);
    const auto mean = [&](int type) {
        double sum = 0.0;
        for (const int s : levels[0].of_type[std::size_t(type)])
            sum += levels[0].all[std::size_t(s)].land->mean(0, 0, 53, 53);
        return sum / 2.0;
    };
    const double step = mean(0) - mean(1);  // hills, plain
    ASSERT_GT(step, 300.0);
    EXPECT_NEAR(base.pattern(0, 20), mean(0), 0.2 * step);
    EXPECT_NEAR(base.pattern(39, 20), mean(1), 0.2 * step);
    double steepest = 0.0;
    for (int x = 0; x + 1 < 40; ++x) {
        const double drop = base.pattern(x, 20) - base.pattern(x + 1, 20);
        EXPECT_GE(drop, -1e-3);
        steepest = std::max(steepest, drop);
    }
    EXPECT_LT(steepest, 0.5 * step);
    // The slope lies in the hills: plains stay plain.
    EXPECT_LT(base.pattern(20, 20) - mean(1), 0.25 * step);
}

TEST_F(Evolution, LandIsLikeItsTypes) {
    for (const Optimiser optimiser : {Optimiser::kTexture, Optimiser::kEvolution}) {
        options_.optimiser = optimiser;
        const Terrain land = made();
        const double west = deviation_of_slope(land.heights, 5, 45),
                     east = deviation_of_slope(land.heights, 75, 115);
        const Field<float> hills = rough(160, 160, 3);
        const double own = deviation_of_slope(hills, 0, 160);
        EXPECT_NEAR(east / own, 1.0, 0.3);
        EXPECT_LT(west / own, 0.2);
        EXPECT_EQ(land.masks.at("type-plain")(2, 60), 1.0f);
        EXPECT_EQ(land.masks.at("type-hills")(2, 60), 0.0f);
        EXPECT_EQ(land.pictures.at("types").width(), 120);
    }
}

TEST_F(Evolution, FinerLevelsKeepCoarserOnes) {
    options_.optimiser = Optimiser::kEvolution;
    const auto levels = samples(3);
    Regions regions = halves(108);
    std::swap(regions.types[0], regions.types[1]);
    const auto done = height_field(regions, levels, 3, options_.evolution, {}, nullptr,
                                   0.0, 0.0, 3, listener_);
    ASSERT_EQ(done.size(), 3u);
    const Field<float> means = coarser(done[2].heights, 3);
    double off = 0.0, relief = 0.0;
    for (std::size_t i = 0; i < means.size(); ++i) {
        off += std::abs(means[i] - done[1].heights[i]) / double(means.size());
        relief += std::abs(means[i] - 350.0) / double(means.size());
    }
    EXPECT_LT(off, 0.02 * relief);
    EXPECT_LE(done[2].seam_energy, 1.3);
}

TEST_F(Evolution, IsTheSameForAnyNumberOfThreads) {
    for (const Optimiser optimiser : {Optimiser::kTexture, Optimiser::kEvolution}) {
        options_.optimiser = optimiser;
        const auto with = [&](std::size_t threads) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                            threads);
            return made(5).heights;
        };
        const Field<float> one = with(1);
        EXPECT_EQ(one, with(4));
        EXPECT_NE(one, made(6).heights);
    }
}

TEST_F(Evolution, PlacedFeaturesAreThere) {
    geometry::Point point;
    point.name = "summit";
    point.at = {metres(1815.0), metres(1815.0)};
    point.height = 1500.0;
    point.radius = metres(600.0);
    options_.points = {point};
    geometry::Curve river{.name = "river", .points = {}};
    river.points = {{metres(915.0), metres(300.0)}, {metres(915.0), metres(3300.0)}};
    river.height = 40.0;
    river.area = {metres(150.0), metres(150.0)};
    options_.curves = {river};
    const Terrain land = made();
    EXPECT_NEAR(land.heights(60, 59), 1500.0, 3.0);
    EXPECT_GT(land.heights(64, 59), 1000.0);  // with land around it
    for (int y = 20; y < 100; ++y) EXPECT_NEAR(land.heights(30, y), 40.0, 2.0);
}

TEST_F(Evolution, AutomaticMapsUseAllTypes) {
    options_.map = {};
    options_.map.automatic = 9;
    const Terrain land = made();
    EXPECT_EQ(land.masks.size(), 2u);
    EXPECT_GE(land.figures.at("genetic: regions"), 2.0);
}

TEST_F(Evolution, RatiosOfTwoAndAnyStart) {
    options_.ratio = 2, options_.coarsest = 250.0;
    EXPECT_EQ(made().figures.at("genetic: levels"), 4.0);  // 240, 120, 60, 30 m
    options_.coarsest = 30.0;
    EXPECT_EQ(made().figures.at("genetic: levels"), 1.0);
}

TEST_F(Evolution, RefusesTypesWithoutSamples) {
    options_.library.types[0].examples.clear();
    EXPECT_NE(refused().find("the type 'hills' of  has no samples to make land of"),
              std::string::npos)
        << refused();
    // One that no region is of may be empty.
    options_.map.regions[1].type = "plain";
    EXPECT_EQ(refused(), "");
}

TEST_F(Evolution, OneSampleIsEnough) {
    for (auto& type : options_.library.types) type.examples.resize(1);
    EXPECT_EQ(refused(), "");
}

TEST_F(Evolution, WindowsThatHoldNothingAreRefused) {
    options_.library.types[0].examples[0].window = {0.5, 0.5, 0.501, 0.501};
    EXPECT_NE(refused().find("hills0.tif: its window holds"), std::string::npos)
        << refused();
}

TEST_F(Evolution, VoidsAreNoLand) {
    // A model that is half void: nothing is taken from where heights were interpolated.
    Field<float> holed = rough(160, 160, 3);
    for (int y = 40; y < 120; ++y)
        for (int x = 40; x < 120; ++x) holed(x, y) = std::nanf("");
    options_.library.types[0].examples.clear();
    add("hills", "holed.tif", holed);
    options_.optimiser = Optimiser::kEvolution;
    const auto levels = samples(1);
    const SampleLand& land = *levels[0].all[0].land;
    EXPECT_TRUE(land.any_void(60, 60, 16, 16));
    EXPECT_FALSE(land.any_void(2, 2, 16, 16));
    EXPECT_EQ(refused(), "");
}

TEST_F(Evolution, SmallSamplesMakeSmallGenes) {
    for (auto& type : options_.library.types) type.examples.clear();
    add("hills", "small.tif", rough(14, 14, 3));
    add("plain", "flat.tif", rough(14, 14, 4));
    EXPECT_EQ(refused(), "");
}

}  // namespace
}  // namespace cydonia::genetic
