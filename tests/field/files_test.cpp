#include "field/files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "field/progress.h"
#include "tests/field/small_disk.h"
#include "tests/field/temporary_folder.h"

namespace cydonia {
namespace {

namespace fs = std::filesystem;

std::size_t count_files(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(WriteText, ReadsBackEveryByte) {
    const TemporaryFolder folder;
    const std::string text("a\0b\r\n\xff", 6);
    write_text(folder / "a.txt", text);
    EXPECT_EQ(read_text(folder / "a.txt"), text);
    write_text(folder / "a.txt", "");
    EXPECT_EQ(read_text(folder / "a.txt"), "");
    EXPECT_EQ(count_files(folder.path()), 1u);
}

TEST(WriteAtomically, TemporaryNameIsBesideWithTheSameExtension) {
    const TemporaryFolder folder;
    write_atomically(folder / "a.exr", [&](const fs::path& temporary) {
        EXPECT_EQ(temporary.parent_path(), folder.path());
        EXPECT_EQ(temporary.extension(), ".exr");
        EXPECT_FALSE(fs::exists(folder / "a.exr"));
        std::ofstream(temporary) << "x";
    });
    EXPECT_EQ(read_text(folder / "a.exr"), "x");
}

TEST(WriteAtomically, ExceptionLeavesTheOldFileAndNothingElse) {
    const TemporaryFolder folder;
    const fs::path path = folder.with("a.txt", "old");
    const auto failing = [&](auto exception) {
        write_atomically(path, [&](const fs::path& temporary) {
            std::ofstream(temporary) << "half";
            throw exception;
        });
    };
    expect_error(ExitCode::kFailed, "a.txt: oops",
                 [&] { failing(std::runtime_error("oops")); });
    expect_error(ExitCode::kBadRequest, "mine", [&] { failing(bad_request("mine")); });
    EXPECT_THROW(failing(Interrupted{}), Interrupted);
    EXPECT_EQ(read_text(path), "old");
    EXPECT_EQ(count_files(folder.path()), 1u);
}

TEST(WriteAtomically, WriterThatWritesNothing) {
    const TemporaryFolder folder;
    expect_error(ExitCode::kFailed, "a.txt",
                 [&] { write_atomically(folder / "a.txt", [](const fs::path&) {}); });
}

TEST(WriteText, FullDisk) {
    const TemporaryFolder folder;
    const fs::path path = folder.with("a.txt", "old");
    {
        const SmallDisk disk(4096);
        expect_error(ExitCode::kFailed, "a.txt: File too large",
                     [&] { write_text(path, std::string(5000, 'x')); });
        expect_error(ExitCode::kFailed, "a.txt: File too large",
                     [&] { write_text(path, std::string(1 << 20, 'x')); });
    }
    EXPECT_EQ(read_text(path), "old");
    EXPECT_EQ(count_files(folder.path()), 1u);
}

TEST(WriteText, PlacesThatCannotBeWritten) {
    const TemporaryFolder folder;
    folder.with("file", "x");
    fs::create_directory(folder / "folder");
    fs::create_symlink("/dev/null", folder / "device");
    const auto fails = [&](std::string_view name, std::string_view words) {
        expect_error(ExitCode::kFailed, words, [&] { write_text(folder / name, "y"); });
    };
    fails("file/a.txt", "file/a.txt: Not a directory");
    fails("missing/a.txt", "missing/a.txt: No such file or directory");
    fails("folder", "folder: a folder has that name");
    fails("device", "device: it is not a regular file");
}

TEST(ReadText, Refusals) {
    const TemporaryFolder folder;
    folder.with("long.txt", std::string(1001, 'x'));
    const auto fails = [&](std::string_view name, std::string_view words) {
        expect_error(ExitCode::kBadRequest, words,
                     [&] { read_text(folder / name, 1000); });
    };
    fails("long.txt", "larger than 1000 bytes");
    fails("missing.txt", "missing.txt: No such file");
    fails("", "it is a folder");
    EXPECT_EQ(read_text(folder / "long.txt", 1001).size(), 1001u);
}

TEST(MakeFolder, ParentsAndAgain) {
    const TemporaryFolder folder;
    make_folder(folder / "a/b/c");
    make_folder(folder / "a/b/c");
    EXPECT_TRUE(fs::is_directory(folder / "a/b/c"));
}

TEST(MakeFolder, NamesWhatIsInTheWay) {
    const TemporaryFolder folder;
    folder.with("file", "x");
    expect_error(ExitCode::kFailed, (folder / "file").string() + " is a file",
                 [&] { make_folder(folder / "file/b/c"); });
    expect_error(ExitCode::kFailed, (folder / "file").string() + " is a file",
                 [&] { make_folder(folder / "file"); });
}

}  // namespace
}  // namespace cydonia
