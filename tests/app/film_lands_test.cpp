// The lands of films whose scene varies in time, and POV-Ray's files of them.
#include "app/sequence/film_lands.h"

#include <gtest/gtest.h>

#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

struct FilmLandsTest : testing::Test {
    TemporaryFolder folder;
    SilentProgress progress;

    Request request() const {
        Request request;
        request.scene = folder.write("scene.toml", kSmallScene);
        request.overrides = {"terrain.samples=32"};
        request.output = folder / "out";
        request.quality = render::Quality::kDraft;
        return request;
    }
    // A frame whose land has this seed; the job's has 7.
    static SequenceFrame frame(const Job& job, std::uint64_t seed) {
        config::SceneSpec scene = *job.spec;
        scene.seed = seed;
        return {.camera = job.cameras().front(),
                .scene = std::make_shared<const config::SceneSpec>(scene)};
    }
};

}  // namespace

TEST_F(FilmLandsTest, ALandIsSharedByItsFramesAndGoneWithTheLast) {
    const Job job(request(), progress);
    fs::path pov;
    {
        FilmLands lands(job);
        const FrameLand one = lands.of(frame(job, 8)), same = lands.of(frame(job, 8)),
                        other = lands.of(frame(job, 9));
        EXPECT_TRUE(one.is_temporary);
        EXPECT_EQ(one.key, same.key);
        EXPECT_NE(one.key, other.key);
        auto site = one.site();
        EXPECT_EQ(same.site(), site);
        pov = site->pov;
        EXPECT_EQ(pov.parent_path(), folder / "out/.cache/lands/all");
        EXPECT_TRUE(fs::exists(pov / "heights.png"));
        other.site();
        EXPECT_TRUE(fs::exists(pov / "heights.png")) << "a frame is traced from it";
        site.reset();
        EXPECT_FALSE(fs::exists(pov));
    }
    EXPECT_EQ(files_below(folder / "out/.cache/lands"), std::vector<std::string>{});
}

TEST_F(FilmLandsTest, TheJobsOwnLandIsKept) {
    const Job job(request(), progress);
    FilmLands lands(job);
    for (const FrameLand& land :
         {lands.of({.camera = job.cameras().front()}), lands.of(frame(job, 7))}) {
        EXPECT_FALSE(land.is_temporary);
        EXPECT_EQ(land.site()->terrain, job.land.drawn());
        EXPECT_EQ(land.site()->pov, folder / "out/pov");
    }
}

// What cameras of any name have left in pov/ is not ours to remove.
TEST_F(FilmLandsTest, LeftoversAreRemovedAndNothingElse) {
    const Job job(request(), progress);
    for (const char* file :
         {"pov/land-a.exr", "pov/land-a.pov", "pov/land-0123456789abcdef/x.png",
          ".cache/lands/all/0123456789abcdef/heights.png",
          ".cache/lands/0-7/0123456789abcdef/heights.png", ".cache/steps.jsonl"})
        folder.write(std::string("out/") + file, "x");

    Request beside = request();
    beside.trace_only = true;
    beside.frames = {0, 7};
    const Job traces(beside, progress);
    FilmLands(traces).remove_leftovers();
    EXPECT_FALSE(fs::exists(folder / "out/.cache/lands/0-7"));
    EXPECT_TRUE(fs::exists(folder / "out/.cache/lands/all")) << "of another process";

    FilmLands(job).remove_leftovers();
    EXPECT_EQ(
        files_below(folder / "out"),
        (std::vector<std::string>{".cache/steps.jsonl", "pov/land-0123456789abcdef/x.png",
                                  "pov/land-a.exr", "pov/land-a.pov"}));
}
