// Names that become files: no two of a request's steps write one file.
#include <gtest/gtest.h>

#include "app/pipeline/steps.h"
#include "app/request.h"
#include "field/error.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"

using namespace cydonia;
using namespace cydonia::test;

namespace {

// A scene that can be filmed in every way, whose second camera has this name.
std::string scene_with(const std::string& camera) {
    const std::string head =
        kShadowScene.substr(0, kShadowScene.find("[[render.camera]]"));
    return head + R"([frames]
count = 3
[[render.camera]]
name = "flight"
kind = "path"
shutter_samples = 2
[[render.camera.key]]
frame = 0
eye = [640.0, 100.0, 900.0]
target = [640.0, 700.0, 0.0]
[[render.camera.key]]
frame = 2
eye = [640.0, 300.0, 900.0]
target = [640.0, 900.0, 0.0]
[[render.camera]]
kind = "overhead"
name = ")" +
           camera + "\"\n";
}

// What a request for this is refused with; empty: it is not.
std::string refusal(const std::string& camera, Goal goal,
                    std::optional<render::Style> preview = {}) {
    const TemporaryFolder folder;
    folder.write("bar.svg", kBar);
    Request request;
    request.scene = folder.write("scene.toml", scene_with(camera));
    request.output = folder / "out";
    request.preview = preview;
    SilentProgress progress;
    const Job job(request, progress);
    Ledger ledger(job.folder);
    const Graph graph(steps_of(job), ledger);
    try {
        refuse_equal_outputs(graph.closure(names_taken(goal, job)));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kBadRequest);
        return error.what();
    }
    return "";
}

}  // namespace

TEST(Names, ACameraCalledLikeAFrameIsRefusedWhereThatIsFilmed) {
    struct Case {
        const char* camera;
        Goal goal;
        const char* step;
    };
    for (const Case& c : {Case{"day-0003", Goal::kSweep, "'film day'"},
                          {"turntable-0001", Goal::kTurntable, "'film turntable'"},
                          {"film-0002", Goal::kFilm, "'film film'"}}) {
        const std::string message = refusal(c.camera, c.goal);
        for (const std::string& word :
             {std::string(c.step), std::string(c.camera) + "'", std::string("rename")})
            EXPECT_NE(message.find(word), std::string::npos)
                << c.camera << ": " << message;
        EXPECT_EQ(refusal(c.camera, Goal::kFrames), "") << "a still of its own";
    }
    EXPECT_EQ(refusal("film-0004", Goal::kFilm), "") << "there is no such frame";
    EXPECT_EQ(refusal("film-0002-s002", Goal::kFilm), "") << "no moment is called so";
    EXPECT_EQ(refusal("day", Goal::kSweep), "") << "nor is the video a picture";
}

TEST(Names, ACameraCalledLikeAFrameOfALookIsRefused) {
    const auto ink = render::Style::kInk;
    EXPECT_NE(
        refusal("turntable-ink-0003", Goal::kTurntable, ink).find("'film turntable "),
        std::string::npos);
    EXPECT_EQ(refusal("turntable-grey-0003", Goal::kTurntable, ink), "");
    EXPECT_EQ(refusal("turntable-0003", Goal::kTurntable, ink), "");
    EXPECT_EQ(refusal("turntable-ink-0003", Goal::kTurntable), "");
    EXPECT_EQ(refusal("turntable-ink-0003", Goal::kFrames, ink), "");
}
