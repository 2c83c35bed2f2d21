// Terrains of a scene, asked for in any order and by any thread.
#include "app/pipeline/land_store.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

// Counts how often a stage reports: not at all where its land is not made.
class Counting final : public Progress {
  public:
    void step(std::string_view) override {}
    void report(double) override { ++reports; }
    void note(std::string_view) override {}
    void warn(std::string_view) override {}
    std::atomic<int> reports = 0;
};

struct LandStoreTest : testing::Test {
    TemporaryFolder folder;
    Counting progress;

    LandStore store(const std::string& more = "",
                    render::Quality quality = render::Quality::kDraft) {
        const fs::path scene = folder.write(
            "scene.toml", kSmallScene +
                              "[[terrain.stage]]\nmethod = \"distance\"\n"
                              "[[terrain.stage.group]]\npeaks = { count = 2 }\n" +
                              more);
        return {
            std::make_shared<const config::SceneSpec>(config::Scene::load(scene).at(0.0)),
            quality, folder / ".cache", progress};
    }
};

}  // namespace

TEST_F(LandStoreTest, ALandStaysAsItIsWhileItIsHeld) {
    const LandStore lands = store();
    const auto first = lands.get(1);
    const Field<float> heights = first->heights;
    const auto finished = lands.finished();
    EXPECT_NE(finished->heights, heights);
    EXPECT_EQ(lands.get(0)->heights, Field<float>(64, 64));
    EXPECT_EQ(first->heights, heights);
    EXPECT_EQ(lands.get(1), first) << "the very same";
    EXPECT_EQ(lands.finished(), finished);
}

TEST_F(LandStoreTest, KeepsTheLastOneOnly) {
    const LandStore lands = store();
    const std::weak_ptr<const Terrain> first = lands.get(1), second = lands.get(2);
    EXPECT_TRUE(first.expired());
    EXPECT_FALSE(second.expired());
}

TEST_F(LandStoreTest, MakesEachOnce) {
    Field<float> heights;
    {
        const LandStore lands = store();
        std::vector<LandStore::Handle> handles(8);
        {
            std::vector<std::jthread> threads;
            for (auto& handle : handles)
                threads.emplace_back([&] { handle = lands.finished(); });
        }
        for (const auto& handle : handles) EXPECT_EQ(handle, handles[0]);
        heights = handles[0]->heights;
    }
    const int reports = progress.reports;
    EXPECT_GT(reports, 0);
    EXPECT_EQ(store().finished()->heights, heights);
    EXPECT_EQ(progress.reports, reports) << "read from the cache";
}

TEST_F(LandStoreTest, TheDrawnLandIsOneMore) {
    const LandStore lands = store("[render.fine_relief]\nfactor = 2\n");
    const auto drawn = lands.drawn();
    EXPECT_EQ(drawn->heights.width(), 2 * lands.width());
    EXPECT_EQ(lands.finished()->heights.width(), lands.width());
    EXPECT_EQ(lands.drawn(), drawn);
    EXPECT_NE(lands.drawn_key(), lands.key());
    const LandStore plain = store("[render.fine_relief]\nfactor = 1\n");
    EXPECT_EQ(plain.drawn(), plain.finished());
    EXPECT_EQ(plain.drawn_key(), plain.key());
}

// What is made from other options, seeds or samples has another key.
TEST_F(LandStoreTest, KeysTellLandsApart) {
    const LandStore lands = store();
    EXPECT_NE(lands.key(0), lands.key(1));
    EXPECT_NE(lands.key(1), lands.key(2));
    EXPECT_EQ(store().key(), lands.key());
    const LandStore other = store(
        "[[terrain.stage]]\nmethod = \"distance\"\n"
        "[[terrain.stage.group]]\npeaks = { count = 2 }\n");
    EXPECT_EQ(other.key(2), lands.key(2));
    EXPECT_NE(other.key(3), lands.key(2));
}
