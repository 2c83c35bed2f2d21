#include "synth/detail/detail.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "field/dem.h"
#include "field/error.h"
#include "field/files.h"
#include "field/noise.h"
#include "field/random.h"
#include "synth/detail/fractal.h"
#include "synth/detail/quilting.h"

namespace cydonia::detail {
namespace {

namespace fs = std::filesystem;

constexpr double kSpacing = 10.0;

// Rough mountains, no two parts alike.
Field<float> mountains(int width, int height, std::uint64_t seed) {
    NoiseOptions noise;
    noise.octaves = 6;
    noise.h = 0.9;
    return noise_field(noise, width, height, 400.0, seed);
}

Field<float> without_details(const Field<float>& land, int levels) {
    const auto parts = decomposed(land, Filter::kChaikin, levels);
    Field<float> smooth = parts.back().coarse;
    for (int level = levels; level-- > 0;)
        smooth = subdivided(smooth,
                            no_details(Filter::kChaikin, smooth.width(), smooth.height()),
                            Filter::kChaikin);
    return smooth;
}

// What subdivision alone does not give.
double roughness(const Field<float>& land, int x0, int y0, int x1, int y1) {
    const Field<float> smooth = without_details(land, 1);
    double squares = 0.0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const double rest = land(x, y) - smooth(x, y);
            squares += rest * rest;
        }
    return std::sqrt(squares / (double(x1 - x0) * (y1 - y0)));
}
double roughness(const Field<float>& land) {
    return roughness(land, 0, 0, land.width(), land.height());
}

struct Said final : Progress {
    std::string warnings, notes;
    void step(std::string_view) override {}
    void report(double) override {}
    void warn(std::string_view sentence) override { warnings += sentence; }
    void note(std::string_view sentence) override { notes += sentence; }
};

class Detail : public testing::Test {
  protected:
    Detail() { fs::create_directories(folder_); }
    ~Detail() override { fs::remove_all(folder_); }

    Source model(const Field<float>& heights, double spacing = kSpacing) {
        Terrain terrain;
        terrain.heights = heights;
        terrain.spacing = spacing;
        const fs::path file = folder_ / ("model" + std::to_string(models_++) + ".tif");
        write_geotiff(file, terrain);
        return open_source(file);
    }
    Source drawing(const std::string& body) {
        const fs::path file = folder_ / "paint.svg";
        write_text(file,
                   "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'>" +
                       body + "</svg>");
        return open_source(file);
    }
    Field<float> made(const Options& options, const Field<float>& land) {
        Terrain terrain;
        terrain.heights = land;
        terrain.spacing = kSpacing;
        Context context;
        context.seed = 5;
        context.progress = &said_;
        return run(options, terrain, context).heights;
    }
    std::string complaint(const Options& options, const Field<float>& land) {
        try {
            made(options, land);
            return "";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::kBadRequest);
            return error.what();
        }
    }

    Said said_;
    fs::path folder_ =
        fs::temp_directory_path() / ("cydonia_detail_" + std::to_string(getpid()));
    int models_ = 0;
};

// A land whose details were taken away, and mapped onto itself, is what it was.
TEST_F(Detail, MappedOntoItselfRestoresTheLand) {
    const Field<float> land = mountains(250, 186, 1);
    Options options;
    options.targets = {{model(land), {}}};
    options.levels = 2;
    options.mappings = {{.target = 1, .size = {1.0, 1.0}}};
    const Field<float> smooth = without_details(land, 2);
    const Field<float> again = made(options, smooth);
    double before = 0.0, after = 0.0;
    for (int y = 20; y < 160; ++y)
        for (int x = 20; x < 230; ++x) {
            before = std::max(before, std::abs(double(smooth(x, y)) - land(x, y)));
            after = std::max(after, std::abs(double(again(x, y)) - land(x, y)));
        }
    EXPECT_GT(before, 5.0);
    EXPECT_LT(after, 0.01);
}

TEST_F(Detail, LandThatIsNotMappedKeepsItsBytes) {
    const Field<float> land = mountains(200, 200, 2);
    Options options;
    options.targets = {{model(mountains(300, 300, 3)), {}}};
    options.mappings = {{.to = {0.75, 0.25}, .size = {0.3, 0.3}}};
    const Field<float> result = made(options, land);
    int changed = 0;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            const bool near = x > 110 && y > 110;
            if (!near) {
                ASSERT_EQ(result(x, y), land(x, y)) << x << ", " << y;
            }
            changed += result(x, y) != land(x, y);
        }
    EXPECT_GT(changed, 3000);
    EXPECT_NE(result(150, 150), land(150, 150));
}

TEST_F(Detail, AnOutlineIsFilled) {
    const Field<float> land = without_details(mountains(200, 200, 2), 1);
    Options options;
    options.levels = 1;
    options.targets = {{model(mountains(300, 300, 3)), {}}};
    options.mappings = {{.outline = {{0.1, 0.1}, {0.9, 0.1}, {0.1, 0.9}}}};
    const Field<float> result = made(options, land);
    EXPECT_NE(result(60, 140), land(60, 140));
    EXPECT_EQ(result(160, 40), land(160, 40));  // beyond the slanting side
}

TEST_F(Detail, ThreadsDoNotMatter) {
    const Field<float> land = without_details(mountains(190, 150, 4), 2);
    const Source target = model(mountains(260, 240, 5));
    for (const Search search :
         {Search::kRandom, Search::kExhaustive, Search::kPatchMatch})
        for (const Kind kind : {Kind::kCopied, Kind::kMultifractal, Kind::kFractal}) {
            Options options;
            options.targets = {{target, {}}};
            options.search = search;
            options.kind = kind;
            options.adapt = kind == Kind::kCopied;
            Field<float> one;
            {
                const tbb::global_control alone(
                    tbb::global_control::max_allowed_parallelism, 1);
                one = made(options, land);
            }
            const tbb::global_control four(tbb::global_control::max_allowed_parallelism,
                                           4);
            EXPECT_TRUE(std::ranges::equal(one, made(options, land)));
        }
}

// A part of the land that is made alone has the bytes that it has in the whole.
TEST_F(Detail, TilesAreTheLandMadeWhole) {
    const Field<float> land = mountains(430, 390, 31);
    Options options;
    options.targets = {{model(mountains(300, 280, 32)), {}}};
    options.levels = 2;
    options.block = 0.05;
    Context context;
    context.seed = 5;
    context.progress = &said_;
    const auto before = [&](int x, int y, int width, int height) {
        Field<float> part(width, height);
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) part(i, j) = land(x + i, y + j);
        return part;
    };
    EXPECT_LT(reach(options, {430, 390, kSpacing}), 190);
    for (const bool exhaustive : {false, true})
        for (const Kind kind : {Kind::kCopied, Kind::kMultifractal, Kind::kFractal}) {
            options.search = exhaustive ? Search::kExhaustive : Search::kRandom;
            options.adapt = exhaustive;
            options.kind = kind;
            const Field<float> whole = made(options, land);
            for (const auto& [x, y, width, height] :
                 {std::array{0, 0, 64, 50}, std::array{250, 201, 37, 41},
                  std::array{366, 326, 64, 64}}) {
                const Field<float> part = tile(options, {430, 390, kSpacing}, before,
                                               context, x, y, width, height);
                for (int j = 0; j < height; ++j)
                    for (int i = 0; i < width; ++i)
                        ASSERT_EQ(part(i, j), whole(x + i, y + j))
                            << int(kind) << ": " << x + i << ", " << y + j;
            }
        }
}

// The block's own place is in the example: nothing is more like it.
TEST_F(Detail, ExhaustiveSearchFindsTheBlocksOwnPlace) {
    const Field<float> land = mountains(300, 260, 6);
    const std::vector<Example> examples{example_of(land, {}, Filter::kChaikin, 1)};
    const Field<float>& coarse = examples[0].levels[0].coarse;
    Field<float> part(64, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) part(x, y) = coarse(x + 31, y + 17) + 250.0f;
    const Blocks blocks = blocks_of(64, 48, 16);
    const auto all = [](int) { return true; };
    for (const Match& match : matched(part, {}, blocks, examples,
                                      {Search::kExhaustive, 40, 0, 1}, {}, {}, all)) {
        EXPECT_EQ(match.example, 0);
        EXPECT_EQ(match.dx, 31);
        EXPECT_EQ(match.dy, 17);
    }
}

// The more is tried, the more alike the land: random, PatchMatch, all.
TEST_F(Detail, SearchesAreInOrder) {
    const Field<float> land = mountains(300, 300, 7);
    const std::vector<Example> examples{
        example_of(mountains(500, 500, 8), {}, Filter::kChaikin, 1)};
    const Blocks blocks = blocks_of(300, 300, 30);
    const auto all = [](int) { return true; };
    const auto dissimilarity = [&](Search search) {
        double sum = 0.0;
        const auto matches =
            matched(land, {}, blocks, examples, {search, 20, 0, 1}, {}, {}, all);
        for (int block = 0; block < blocks.across() * blocks.down(); ++block) {
            const Match& m = matches[std::size_t(block)];
            const int x0 = block % blocks.across() * blocks.step,
                      y0 = block / blocks.across() * blocks.step;
            const int x1 = std::min(300, x0 + blocks.side()),
                      y1 = std::min(300, y0 + blocks.side());
            double total = 0.0, squares = 0.0;
            for (int y = y0; y < y1; ++y)
                for (int x = x0; x < x1; ++x) {
                    const double step =
                        land(x, y) - examples[0].levels[0].coarse(x + m.dx, y + m.dy);
                    total += step, squares += step * step;
                }
            const double n = double(x1 - x0) * (y1 - y0);
            sum += squares / n - total / n * total / n;
        }
        return sum;
    };
    const double random = dissimilarity(Search::kRandom),
                 patchmatch = dissimilarity(Search::kPatchMatch),
                 every = dissimilarity(Search::kExhaustive);
    EXPECT_LT(patchmatch, 0.9 * random);
    EXPECT_LT(every, patchmatch);
}

// Unrelated lands that fade into each other are as rough there as alone.
TEST_F(Detail, OverlapsKeepTheVariance) {
    Field<float> noise(400, 400);
    for (std::size_t i = 0; i < noise.size(); ++i)
        noise[i] = float(signed_unit(hash_of({i})));
    const std::vector<Example> examples{example_of(noise, {}, Filter::kHaar, 1)};
    const Blocks blocks{150, 150, 12, 12};  // nearly nothing but overlaps
    std::vector<Match> matches;
    for (int block = 0; block < blocks.across() * blocks.down(); ++block) {
        const int x = block % blocks.across() * blocks.step,
                  y = block / blocks.across() * blocks.step;
        matches.push_back({0, int(hash_of({1, std::uint64_t(block)}) % 170) - x,
                           int(hash_of({2, std::uint64_t(block)}) % 170) - y});
    }
    const auto deviation = [](const Field<float>& field) {
        double squares = 0.0;
        for (const float v : field) squares += double(v) * v;
        return std::sqrt(squares / double(field.size()));
    };
    const double own = deviation(examples[0].levels[0].details.columns);
    const auto of = [&](Fading fading) {
        return deviation(
            quilted(150, 150, {}, blocks, matches, examples, 0, Filter::kHaar, fading)
                .columns);
    };
    EXPECT_NEAR(of(Fading::kVariance) / own, 1.0, 0.03);
    EXPECT_LT(of(Fading::kMean) / own, 0.8);
}

// Overlapping blocks of one and the same land are that land.
TEST_F(Detail, BlocksThatAgreeAreSeamless) {
    const Field<float> land = mountains(180, 180, 9);
    const std::vector<Example> examples{example_of(land, {}, Filter::kChaikin, 1)};
    const Level& level = examples[0].levels[0];
    const Blocks blocks = blocks_of(level.coarse.width(), level.coarse.height(), 12);
    const std::vector<Match> same(std::size_t(blocks.across() * blocks.down()),
                                  Match{0, 0, 0});
    const Details details = quilted(blocks.width, blocks.height, {}, blocks, same,
                                    examples, 0, Filter::kChaikin, Fading::kVariance);
    for (std::size_t i = 0; i < details.rows.size(); ++i)
        ASSERT_NEAR(details.rows[i], level.details.rows[i], 1e-4);
    for (std::size_t i = 0; i < details.columns.size(); ++i)
        ASSERT_NEAR(details.columns[i], level.details.columns[i], 1e-4);
}

TEST_F(Detail, LevelTargetsGiveNothing) {
    const Field<float> land = mountains(146, 146, 10);
    Options options;
    options.targets = {{model(Field<float>(300, 300, 250.0f)), {}}};
    const Field<float> result = made(options, land), smooth = without_details(land, 3);
    for (std::size_t i = 0; i < land.size(); ++i) ASSERT_NEAR(result[i], smooth[i], 0.01);
}

TEST_F(Detail, StrengthMultiplies) {
    const Field<float> land = without_details(mountains(200, 200, 11), 1);
    Options options;
    options.levels = 1;
    options.targets = {{model(mountains(400, 400, 12)), {}}};
    const double once = roughness(made(options, land));
    options.strength = 2.0;
    EXPECT_GT(once, 1.0);
    EXPECT_NEAR(roughness(made(options, land)), 2.0 * once, 0.01 * once);
}

TEST_F(Detail, PaintSaysWhichTargetIsWhere) {
    Field<float> rough = mountains(400, 400, 13), calm = rough;
    for (float& height : calm) height *= 0.1f;
    Options options;
    options.levels = 1;
    options.targets = {{model(rough), {{255, 0, 0}}, 1.0},
                       {model(calm), {{0, 0, 255}}, 1.0}};
    options.paint = drawing(
        "<rect width='40' height='100' fill='#ff0000'/>"
        "<rect x='60' width='40' height='100' fill='#0000ff'/>");
    const Field<float> land = without_details(mountains(300, 300, 14), 1);
    const Field<float> result = made(options, land);
    const double west = roughness(result, 20, 20, 90, 280),
                 east = roughness(result, 210, 20, 280, 280);
    EXPECT_GT(west, 5.0 * east);
    EXPECT_GT(east, 0.1);
    for (int y = 0; y < 300; ++y) ASSERT_EQ(result(150, y), land(150, y));
}

// Noise is as strong as details are where the land is like that: one half of this target
// is rough and steep, the other one level.
TEST_F(Detail, MultifractalsKnowWhereItIsRough) {
    Field<float> target = mountains(400, 400, 15);
    for (int y = 0; y < 400; ++y)
        for (int x = 200; x < 400; ++x) target(x, y) = 0.0f;
    Field<float> land = without_details(target, 2);
    Options options;
    options.levels = 2;
    options.targets = {{model(target), {}}};
    options.search = Search::kExhaustive;
    options.kind = Kind::kMultifractal;
    const Field<float> multi = made(options, land);
    EXPECT_GT(roughness(multi, 20, 20, 160, 380),
              8.0 * roughness(multi, 240, 20, 380, 380));
    options.kind = Kind::kFractal;
    const Field<float> fractal = made(options, land);
    EXPECT_LT(roughness(fractal, 20, 20, 160, 380),
              2.0 * roughness(fractal, 240, 20, 380, 380));
}

// Voss: additions of a level are 2^-H as strong as those of the next coarser one.
TEST_F(Detail, FractalsFadeByTheirHurstExponent) {
    const std::vector<Example> examples{
        example_of(mountains(300, 300, 16), {}, Filter::kChaikin, 3)};
    const auto scale = [&](int level) {
        return fractal_scale(examples, Filter::kChaikin, level, 3);
    };
    EXPECT_NEAR(scale(1) / scale(2), std::exp2(-0.85), 1e-9);
    EXPECT_NEAR(scale(0) / scale(1), std::exp2(-0.85), 1e-9);
    Field<float> noise(500, 500);
    add_noise(noise, {}, 3.0, {}, 1, 0);
    double sum = 0.0, squares = 0.0;
    for (const float v : noise) sum += v, squares += double(v) * v;
    EXPECT_NEAR(sum / 250000.0, 0.0, 0.03);
    EXPECT_NEAR(std::sqrt(squares / 250000.0), 3.0, 0.03);
}

// Level ground in real land stays so, though the target has none.
TEST_F(Detail, AdaptedDetailsFollowTheLand) {
    Field<float> land = without_details(mountains(400, 400, 17), 1);
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 400; ++x) land(x, y) *= x < 200 ? 1.0f : 0.05f;
    Options options;
    options.levels = 1;
    options.targets = {{model(mountains(400, 400, 18)), {}}};
    const auto contrast = [&] {
        const Field<float> result = made(options, land);
        return roughness(result, 20, 20, 180, 380) / roughness(result, 220, 20, 380, 380);
    };
    EXPECT_LT(contrast(), 2.0);
    options.adapt = true;
    EXPECT_GT(contrast(), 6.0);
}

TEST_F(Detail, OrientationsAreEightAndTurnRound) {
    const Field<float> land = mountains(7, 5, 19);
    std::vector<Field<float>> all;
    for (int o = 0; o < 8; ++o) all.push_back(oriented(land, o));
    EXPECT_TRUE(std::ranges::equal(all[0], land));
    for (int a = 0; a < 8; ++a)
        for (int b = 0; b < a; ++b)
            EXPECT_FALSE(all[a].same_shape(all[b]) && std::ranges::equal(all[a], all[b]));
    Field<float> turned = land;
    for (int i = 0; i < 4; ++i) turned = oriented(turned, 1);
    EXPECT_TRUE(std::ranges::equal(turned, land));
    EXPECT_TRUE(std::ranges::equal(oriented(all[4], 4), land));
}

// A block turned by a quarter is only in the target when that may be turned too.
TEST_F(Detail, TurnedBlocksAreFoundWhenAskedFor) {
    const Field<float> target = mountains(300, 300, 20);
    const Field<float> land = oriented(target, 1);
    Options options;
    options.levels = 1;
    options.targets = {{model(target), {}}};
    options.search = Search::kExhaustive;
    const auto error = [&] {
        const Field<float> result = made(options, without_details(land, 1));
        double squares = 0.0;
        for (int y = 30; y < 270; ++y)
            for (int x = 30; x < 270; ++x)
                squares += std::pow(double(result(x, y)) - land(x, y), 2.0);
        return squares;
    };
    const double without = error();
    options.orientations = 4;
    EXPECT_LT(error(), 0.05 * without);
}

TEST_F(Detail, UnknownLandIsNotTaken) {
    const Field<float> land = mountains(200, 200, 21);
    Field<std::uint8_t> voids(200, 200);
    for (int y = 0; y < 200; ++y)
        for (int x = 90; x < 200; ++x) voids(x, y) = 1;
    const std::vector<Example> examples{example_of(land, voids, Filter::kChaikin, 1)};
    const Blocks blocks = blocks_of(60, 60, 12);
    for (const Search search : {Search::kRandom, Search::kPatchMatch})
        for (const Match& match :
             matched(mountains(60, 60, 22), {}, blocks, examples, {search, 40, 0, 1}, {},
                     {}, [](int) { return true; }))
            if (match.example >= 0) {
                EXPECT_LT(match.dx, 45);
            }
}

TEST_F(Detail, ATargetOfVoidsIsRefused) {
    Terrain terrain;
    terrain.spacing = kSpacing;
    terrain.heights = mountains(200, 200, 33);
    const Field<std::uint8_t> all(200, 200, 1);
    const std::vector<Example> examples{
        example_of(terrain.heights, all, Filter::kChaikin, 1)};
    EXPECT_THROW(matched(mountains(60, 60, 22), {}, blocks_of(60, 60, 12), examples,
                         {Search::kRandom, 40, 0, 1}, {}, {}, [](int) { return true; }),
                 Error);
}

TEST_F(Detail, OtherSpacingsAreResampledAndSaid) {
    Options options;
    options.levels = 2;
    options.targets = {{model(mountains(500, 500, 23), 7.0), {}}};
    made(options, mountains(150, 150, 24));
    EXPECT_NE(said_.notes.find("resampled to 10 m"), std::string::npos) << said_.notes;
}

TEST_F(Detail, CoarseTargetsGiveCoarseDetailsOnly) {
    const Field<float> land = without_details(mountains(300, 300, 25), 2);
    Options options;
    options.levels = 2;
    options.targets = {{model(mountains(300, 300, 26), 20.0), {}}};
    const Field<float> result = made(options, land);
    EXPECT_NE(said_.warnings.find("finest level"), std::string::npos) << said_.warnings;
    EXPECT_LT(roughness(result), 0.5);
    const Field<float> half = decomposed(result, Filter::kChaikin, 1)[0].coarse;
    EXPECT_GT(roughness(half, 0, 0, 148, 148), 1.0);

    options.targets = {{model(mountains(300, 300, 26), 90.0), {}}};
    EXPECT_NE(complaint(options, land).find("too coarse"), std::string::npos);
}

TEST_F(Detail, WhatCannotBeDoneIsRefused) {
    const Field<float> land = mountains(200, 200, 27);
    Options options;
    options.targets = {{model(mountains(6, 6, 28)), {}}};
    EXPECT_NE(complaint(options, land).find("too few"), std::string::npos);
    options.targets = {{model(mountains(60, 60, 28)), {}}};
    options.block = 0.5;
    EXPECT_NE(complaint(options, land).find("no target has room"), std::string::npos);
    options.block = 0.1;
    options.mappings = {{.from = {0.1, 0.5}}};
    EXPECT_NE(complaint(options, land).find("mapping 1"), std::string::npos);
    EXPECT_NE(complaint(options, land).find("make it smaller"), std::string::npos);
}

// 20, 38, 74, 146: Brosz 2007, section 6.
TEST_F(Detail, TheTrialsSizes) {
    Options options;
    const std::vector<Example> examples{
        example_of(mountains(400, 400, 29), {}, Filter::kChaikin, 3)};
    SilentProgress silent;
    const Field<float> land =
        refined(mountains(20, 20, 30), {}, examples, std::vector{Layer{}}, options, {},
                146.0 / 15.0, 1, silent);
    EXPECT_EQ(land.width(), 146);
    EXPECT_EQ(land.height(), 146);
    EXPECT_GT(roughness(land), 1.0);
}

}  // namespace
}  // namespace cydonia::detail
