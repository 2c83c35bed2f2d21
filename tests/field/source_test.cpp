#include "field/source.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "field/data.h"
#include "tests/field/temporary_folder.h"

namespace cydonia {
namespace {

namespace fs = std::filesystem;

TEST(OpenSource, HashOfThePublishedKind) {
    const TemporaryFolder folder;
    const Source source = open_source(folder.with("a.txt", "abc"));
    EXPECT_EQ(source.hash, 0x78af5f94892f3950u);  // xxhsum -H3
    EXPECT_EQ(source.size, 3u);
    EXPECT_EQ(source.name(), "a.txt");
}

TEST(OpenSource, EveryBlockCounts) {
    const TemporaryFolder folder;
    std::string bytes((3 << 20) + 17, 'x');
    const Source source = open_source(folder.with("a", bytes));
    EXPECT_EQ(source.size, bytes.size());
    EXPECT_EQ(open_source(folder.with("b", bytes)).hash, source.hash);
    bytes[1 << 20] = 'y';
    EXPECT_NE(open_source(folder.with("b", bytes)).hash, source.hash);
    bytes[1 << 20] = 'x';
    bytes.back() = 'y';
    EXPECT_NE(open_source(folder.with("b", bytes)).hash, source.hash);
}

TEST(OpenSource, PathIsAbsolute) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "in");
    folder.with("a.txt", "abc");
    EXPECT_EQ(open_source(folder / "in/../a.txt").path, folder / "a.txt");
    const fs::path relative = fs::relative(folder / "a.txt");
    EXPECT_TRUE(open_source(relative).path.is_absolute());
}

TEST(OpenSource, Refusals) {
    const TemporaryFolder folder;
    folder.with("empty", "");
    folder.with("file", "x");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    const auto fails = [&](std::string_view name, std::string_view words) {
        expect_error(ExitCode::kBadRequest, words, [&] { open_source(folder / name); });
    };
    fails("missing", "missing'");
    fails("file/below", "below'");
    fails("", "it is a folder");
    fails("empty", "is empty");
    fails("pipe", "not a regular file");
}

TEST(OpenSource, LargerThanFourGibibytes) {
    const TemporaryFolder folder;
    folder.with("huge", "x");
    fs::resize_file(folder / "huge", (std::uintmax_t{4} << 30) + 1);  // sparse
    expect_error(ExitCode::kBadRequest, "larger than 4 GiB",
                 [&] { open_source(folder / "huge"); });
}

TEST(DataFile, TheVariableComesFirst) {
    const TemporaryFolder folder;
    folder.with("only-here.txt", "x");
    setenv("CYDONIA_DATA", folder.path().c_str(), 1);
    EXPECT_EQ(data_file("only-here.txt"), folder / "only-here.txt");
    EXPECT_TRUE(fs::is_regular_file(data_file("CMakeLists.txt")));  // from the tree
    unsetenv("CYDONIA_DATA");
    expect_error(ExitCode::kFailed, "'only-here.txt' is missing (looked in ",
                 [] { data_file("only-here.txt"); });
}

}  // namespace
}  // namespace cydonia
