// What each method makes of a small scene, held in tests/golden/heights. The key of a
// cached stage contains the method's version: where the heights of a method change and
// its version does not, users get stale land from their caches.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "config/reader/scene.h"
#include "field/dem.h"
#include "synth/stage.h"
#include "tests/app/program.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

constexpr int kSamples = 64, kBlocks = 8;  // a side

const fs::path kRoot = CYDONIA_SOURCE_DIR;

struct Signature {
    std::string versions;       // "distance 12 pareidolia 9"
    std::vector<double> means;  // heights of kBlocks x kBlocks blocks, metres
};

std::string versions_of(const fs::path& scene) {
    std::string text;
    for (const config::StageSpec& stage : config::Scene::load(scene).at(0.0).stages) {
        const Method method = method_of(stage.options);
        text +=
            fmt::format("{}{} {}", text.empty() ? "" : " ", method.name, method.version);
    }
    return text;
}

std::vector<double> block_means(const Field<float>& heights) {
    std::vector<double> sums(kBlocks * kBlocks, 0.0), counts(kBlocks * kBlocks, 0.0);
    for (int y = 0; y < heights.height(); ++y)
        for (int x = 0; x < heights.width(); ++x) {
            const auto block = static_cast<std::size_t>(
                y * kBlocks / heights.height() * kBlocks + x * kBlocks / heights.width());
            sums[block] += heights(x, y);
            counts[block] += 1.0;
        }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
    return sums;
}

Signature signature_in(const fs::path& file) {
    Signature signature;
    std::ifstream in(file);
    std::getline(in, signature.versions);
    for (double mean = 0.0; in >> mean;) signature.means.push_back(mean);
    return signature;
}

void write(const fs::path& file, const Signature& signature) {
    std::ofstream out(file);
    out << signature.versions << '\n';
    for (const double mean : signature.means) out << fmt::format("{:.6g}\n", mean);
}

}  // namespace

struct HeightsOfMethods : testing::TestWithParam<const char*> {};

// Processors differ by 1e-5 of the relief at most (other paths through libm); a change of
// a method moves at least one block by more.
TEST_P(HeightsOfMethods, MoveOnlyWithTheVersion) {
    const fs::path scene = kRoot / "scenes" / GetParam() / "scene.toml";
    const fs::path golden =
        kRoot / "tests/golden/heights" / (GetParam() + std::string(".txt"));
    const TemporaryFolder folder;
    const Outcome made =
        run({folder.path()}, {"synth", scene.string(), "-o", (folder / "out").string(),
                              "--set", fmt::format("terrain.samples={}", kSamples)});
    ASSERT_EQ(made.code, 0) << made.err;
    const Signature now{
        versions_of(scene),
        block_means(read_dem(open_source(folder / "out/terrain.tif")).heights)};
    if (std::getenv("CYDONIA_RECORD")) {
        fs::create_directories(golden.parent_path());
        write(golden, now);
    }

    const Signature held = signature_in(golden);
    ASSERT_EQ(held.means.size(), now.means.size()) << "no heights in " << golden;
    ASSERT_EQ(held.versions, now.versions)
        << "a version has moved: record the new heights with CYDONIA_RECORD=1";
    const auto [low, high] = std::ranges::minmax(held.means);
    double farthest = 0.0;
    for (std::size_t i = 0; i < held.means.size(); ++i)
        farthest = std::max(farthest, std::abs(held.means[i] - now.means[i]));
    EXPECT_LE(farthest, 1e-5 * (high - low))
        << "the heights of this scene have changed, its methods' versions ("
        << now.versions
        << ") have not: raise kVersion of the method that changed, then record the new "
           "heights with CYDONIA_RECORD=1";
}

INSTANTIATE_TEST_SUITE_P(Methods, HeightsOfMethods,
                         testing::Values("running-example", "text", "quilt",
                                         "table-mountain", "by-example", "thirds"),
                         [](const auto& scene) {
                             std::string name = scene.param;
                             std::erase(name, '-');
                             return name;
                         });

// The scenes above use every method.
TEST(HeightsOfAll, CoverAllMethods) {
    std::string all;
    for (const auto& file : fs::directory_iterator(kRoot / "tests/golden/heights"))
        all += signature_in(file).versions + ' ';
    []<class... Options>(const std::string& text, std::variant<Options...>*) {
        for (const StageOptions& options : {StageOptions(Options{})...})
            EXPECT_NE(text.find(std::string(method_of(options).name) + ' '), text.npos)
                << method_of(options).name << ": add a scene of it above";
    }(all, static_cast<StageOptions*>(nullptr));
}
