#include "render/frames/video.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "field/files.h"
#include "field/image.h"
#include "tests/field/temporary_folder.h"
#include "tests/render/environment.h"

namespace cydonia::render {
namespace {

namespace fs = std::filesystem;

class Video : public testing::Test {
  protected:
    // Five grey frames of an odd size.
    Video() {
        for (int i = 0; i < 5; ++i) {
            const auto grey = static_cast<std::uint8_t>(40 * i + 20);
            write_png(folder / fmt::format("day-000{}.png", i + 1),
                      Field<Rgb8>(33, 17, {grey, grey, grey}));
        }
    }
    void encode(const std::string& file, double hold = 0.0) {
        SilentProgress silent;
        encode_video({folder.path(), "day", 5, 24.0, 2, hold}, folder / file, silent);
    }
    // What a shell script in ffmpeg's place, first on the PATH, makes of it.
    void expect_failure(const std::string& script, std::string_view words) {
        const fs::path program = programs.with("ffmpeg", "#!/bin/sh\n" + script);
        fs::permissions(program, fs::perms::owner_all);
        const Environment path(
            "PATH", (programs.path().string() + ":" + std::getenv("PATH")).c_str());
        expect_error(ExitCode::kFailed, words, [&] { encode("day.mp4"); });
        EXPECT_FALSE(fs::exists(folder / "day.mp4"));
        for (const auto& entry : fs::directory_iterator(folder.path()))
            EXPECT_EQ(entry.path().extension(), ".png") << "left behind";
    }

    TemporaryFolder folder, programs;
};

TEST_F(Video, Mp4IsH264OfEvenSize) {
    encode("day.mp4");
    const std::string bytes = read_text(folder / "day.mp4");
    EXPECT_EQ(bytes.substr(4, 4), "ftyp");
    EXPECT_NE(bytes.find("avc1"), bytes.npos);
    EXPECT_LT(bytes.find("moov"), bytes.find("mdat")) << "plays while it loads";
    // Width and height follow in the sample's description, 24 bytes after its name.
    const auto at = bytes.find("avc1", bytes.find("stsd")) + 4 + 24;
    const auto number = [&](std::size_t i) {
        return 256 * static_cast<unsigned char>(bytes.at(i)) +
               static_cast<unsigned char>(bytes.at(i + 1));
    };
    EXPECT_EQ(number(at), 34);
    EXPECT_EQ(number(at + 2), 18);
}

TEST_F(Video, WebpMovesAndHolds) {
    encode("day.webp", 0.5);
    const std::string bytes = read_text(folder / "day.webp");
    EXPECT_EQ(bytes.substr(0, 4) + bytes.substr(8, 4), "RIFFWEBP");
    int frames = 0, milliseconds = 0;
    for (auto at = bytes.find("ANMF"); at != bytes.npos;
         at = bytes.find("ANMF", at + 1)) {
        milliseconds += static_cast<unsigned char>(bytes.at(at + 8 + 12)) +
                        256 * static_cast<unsigned char>(bytes.at(at + 8 + 13));
        ++frames;
    }
    EXPECT_EQ(frames, 5);
    EXPECT_NEAR(milliseconds, 5 * 1000 / 24 + 500, 60);
}

TEST_F(Video, IsTheSameAgain) {
    encode("day.mp4", 1.0);
    const std::string first = read_text(folder / "day.mp4");
    encode("day.mp4", 1.0);
    EXPECT_EQ(read_text(folder / "day.mp4"), first);
}

TEST_F(Video, FfmpegIsMissing) {
    const Environment none("PATH", "/nonexistent");
    expect_error(ExitCode::kFailed, "apt install ffmpeg", [] { ffmpeg_program(); });
    expect_error(ExitCode::kFailed, "apt install ffmpeg", [&] { encode("day.mp4"); });
}

TEST_F(Video, FfmpegFails) {
    expect_failure("echo 'frame=3'; echo 'speed=   1x'; echo No such codec >&2; exit 1",
                   "day.mp4: No such codec");
    expect_failure("exit 1", "it did not say why");
    expect_failure("kill -9 $$", "killed by signal 9");
    expect_failure("for last; do :; done; echo half > \"$last\"; exit 1", "could not");
}

TEST_F(Video, AFrameIsMissing) {
    fs::remove(folder / "day-0004.png");
    expect_error(ExitCode::kFailed, "day-0004.png", [&] { encode("day.mp4"); });
    EXPECT_FALSE(fs::exists(folder / "day.mp4"));
}

}  // namespace
}  // namespace cydonia::render
