#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "app/gallery/contact_sheet.h"
#include "app/gallery/page.h"
#include "field/files.h"
#include "field/image.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::array<int, 2> size_of(const fs::path& image) {
    const Field<Rgba8> pixels = read_rgba(open_source(image));
    return {pixels.width(), pixels.height()};
}

struct Gallery : testing::Test {
    TemporaryFolder folder;
    const fs::path out = folder / "out/gallery";
    Gallery() {
        folder.write(
            "lands/one/scene.toml",
            "# Look at <this>.\n#\n#     and that\n\n# not this\n" + kSmallScene);
        folder.write("lands/two/scene.toml", kSmallScene + kSecondCamera);
    }
    static inline const std::string kSecondCamera =
        "[[render.camera]]\nname = \"side\"\nkind = \"oblique\"\nsize = [96, 48]\n";

    Outcome gallery(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), "gallery");
        more.push_back("lands");
        return run({folder.path()}, more);
    }
    std::string page() const { return read_text(out / "index.html"); }
};

}  // namespace

TEST_F(Gallery, EverySceneIsOnTheSheetAndThePage) {
    const Outcome outcome = gallery();
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(size_of(out / "contact-sheet.png"), (std::array{516, 82}));
    EXPECT_EQ(size_of(out / "contact-sheet.jpg"), (std::array{516, 82}));
    for (const std::string name : {"one", "two"}) {
        EXPECT_TRUE(has(outcome.err, name + " ")) << outcome.err;
        for (const std::string file : {"/overhead.jpg", ".jpg"}) {
            EXPECT_TRUE(fs::exists(out / ("thumbnails/" + name + file)));
            EXPECT_TRUE(has(page(), "src=\"thumbnails/" + name + file + "\""));
        }
        EXPECT_TRUE(has(page(), "cydonia render lands/" + name + "/scene.toml"));
    }
    EXPECT_TRUE(has(page(), "<h2>Small land</h2>"));
    EXPECT_TRUE(has(page(), "<pre>Look at &lt;this&gt;.\n\n    and that\n</pre>"));
    EXPECT_FALSE(has(page(), "not this"));
    EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});
}

TEST_F(Gallery, TheFirstCameraUnlessAllAreAskedFor) {
    gallery();
    EXPECT_FALSE(fs::exists(folder / "out/two/frames/side.png"));
    EXPECT_EQ(gallery({"--all-cameras"}).code, 0);
    EXPECT_TRUE(fs::exists(folder / "out/two/frames/side.png"));
    EXPECT_TRUE(has(page(), "thumbnails/two/side.jpg"));
}

TEST_F(Gallery, AgainMakesOnlyWhatChanged) {
    gallery();
    const auto frame = [&](const char* name) {
        return fs::last_write_time(folder.path() / "out" / name / "frames/overhead.png");
    };
    const auto one = frame("one"), two = frame("two");
    folder.write("lands/two/scene.toml",
                 kSmallScene + "[render]\nsun = { azimuth = 90.0, elevation = 30.0 }\n");
    EXPECT_EQ(gallery({"--quiet"}).err, "");
    EXPECT_EQ(frame("one"), one);
    EXPECT_NE(frame("two"), two);
}

TEST_F(Gallery, ABrokenSceneIsNamedAndTheOthersAreMade) {
    folder.write("lands/broken/scene.toml", "title = \"A <broken> one\"\nsed = 3\n");
    const Outcome outcome = gallery({"--quiet"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(has(outcome.err, "\nbroken: lands/broken/scene.toml:")) << outcome.err;
    EXPECT_EQ(size_of(out / "contact-sheet.png"), (std::array{516, 82}));
    EXPECT_TRUE(has(page(), "thumbnails/two/overhead.jpg"));
    EXPECT_TRUE(has(page(), "unknown key &#39;sed&#39;"));
}

TEST_F(Gallery, AnInterruptedOneGoesOn) {
    const Outcome outcome =
        run_and_signal({folder.path()}, {"gallery", "lands"}, SIGINT,
                       [&] { return fs::exists(folder / "out/one/manifest.json"); });
    EXPECT_EQ(outcome.signal, SIGINT);
    EXPECT_FALSE(fs::exists(out / "index.html"));
    EXPECT_EQ(gallery().code, 0);
    EXPECT_TRUE(fs::exists(out / "index.html"));
}

TEST_F(Gallery, NoScene) {
    for (const std::string name : {"out", "missing"}) {
        const Outcome outcome = run({folder.path()}, {"gallery", name});
        EXPECT_EQ(outcome.code, 2);
        EXPECT_TRUE(has(outcome.err, "no scene in " + name)) << outcome.err;
    }
}

TEST(GalleryPage, NamesTitlesAndMessagesAreEscaped) {
    Exhibit exhibit;
    exhibit.name = "a\"b";
    exhibit.title = "<script>";
    exhibit.command = "cydonia render 'a&b'";
    exhibit.failure = "1 < 2";
    exhibit.pictures = {{"x'y.jpg", "<&>"}};
    const std::string page = page_of({exhibit});
    for (const char* raw : {"a\"b", "<script>", "a&b", "1 < 2", "x'y", "<&>"}) {
        EXPECT_FALSE(has(page, raw)) << raw;
    }
    EXPECT_TRUE(has(page, "<h2>&lt;script&gt;</h2>"));
}

TEST(GalleryPage, TheLeadingCommentEndsWhereTheSceneBegins) {
    EXPECT_EQ(leading_comment("# One.\r\n#  two\n#\ntitle = 1 # three\n# four"),
              "One.\n two\n\n");
    EXPECT_EQ(leading_comment("# only"), "only\n");
    EXPECT_EQ(leading_comment("title = 1"), "");
    EXPECT_EQ(leading_comment(""), "");
}

TEST(ContactSheet, RowsOfSixAndPicturesInWhole) {
    const Rgb8 red{200, 0, 0};
    std::vector<Tile> tiles(7, {"land", Field<Rgb8>(480, 90, red)});
    tiles[1].picture = Field<Rgb8>(300, 300, red);
    const Field<Rgb8> sheet = contact_sheet(tiles);
    EXPECT_EQ(sheet.width(), 12 + 6 * 252);
    EXPECT_EQ(sheet.height(), 12 + (180 + 26 + 12) + (45 + 26 + 12));
    // 240 x 45 on its caption, beside 180 x 180.
    EXPECT_EQ(sheet(12, 12 + 135), red);
    EXPECT_EQ(sheet(251, 12 + 179), red);
    EXPECT_NE(sheet(12, 12 + 134), red);
    EXPECT_EQ(sheet(264 + 30, 12), red);
    EXPECT_EQ(sheet(12 + 100, 230 + 44), red);   // the seventh
    EXPECT_NE(sheet(264 + 100, 230 + 44), red);  // no eighth
}

TEST(ContactSheet, CaptionsStandUnderTheirPictures) {
    const auto ink = [](const std::string& caption) {
        const Field<Rgb8> sheet = contact_sheet({{caption, Field<Rgb8>(1, 1)}});
        int leftmost = sheet.width(), count = 0;
        for (int y = 12 + 1; y < sheet.height(); ++y) {
            for (int x = 0; x < sheet.width(); ++x) {
                if (sheet(x, y)[0] < 100) continue;
                leftmost = std::min(leftmost, x);
                ++count;
            }
        }
        return std::pair(leftmost, count);
    };
    EXPECT_EQ(ink("").second, 0);
    EXPECT_GT(ink("canyon").second, 100);
    EXPECT_GE(ink(std::string(60, 'n')).first, 12);  // smaller, not cut off
}

TEST(ContactSheet, JpegKeepsWithinItsBytes) {
    Field<Rgb8> noise(640, 480);
    std::uint32_t state = 1;
    for (Rgb8& pixel : noise) {
        for (auto& channel : pixel) {
            channel =
                static_cast<std::uint8_t>((state = state * 1664525u + 1013904223u) >> 24);
        }
    }
    EXPECT_LE(jpeg_within(noise, 150'000).size(), 150'000u);
    EXPECT_LE(jpeg_within(noise, 3'000).size(), 3'000u);
    EXPECT_GT(jpeg_within(noise, 3'000).size(), 1'000u);
}
