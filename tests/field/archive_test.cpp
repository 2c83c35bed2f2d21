#include "field/archive.h"

#include <gtest/gtest.h>

#include <fstream>

#include "field/files.h"
#include "tests/field/small_disk.h"
#include "tests/field/temporary_folder.h"

namespace cydonia {
namespace {

constexpr std::string_view kKind = "cydonia archive test 1\n";

struct Point {
    float x = 0.0f, y = 0.0f;
    bool operator==(const Point&) const = default;
};

struct Contents {
    double number = 0.0;
    std::vector<Point> points;
    std::string name;
    Field<float> heights;
    Field<std::uint8_t> mask;
    std::vector<std::uint64_t> aligned;
    bool operator==(const Contents&) const = default;
};

Contents example() {
    Contents c{2.5, {{1, 2}, {3, 4}}, std::string("a\0b", 3), Field<float>(3, 2, 7.0f),
               {},  {1, 2, 3}};
    c.heights(2, 1) = -1.0f;
    return c;
}

std::string body_of(const Contents& c) {
    return archive_of([&](ArchiveWriter& out) {
        out.value(c.number);
        out.vector(c.points);
        out.text(c.name);
        out.field(c.heights);
        out.field(c.mask);
        out.align(8);
        out.values(std::span<const std::uint64_t>(c.aligned));
    });
}

std::optional<Contents> contents_of(std::string_view body) {
    return read_back(body, [](ArchiveReader& in) {
        Contents c;
        c.number = in.value<double>();
        c.points = in.vector<Point>();
        c.name = in.text();
        c.heights = in.field<float>();
        c.mask = in.field<std::uint8_t>();
        in.align(8);
        const auto values = in.values<std::uint64_t>(3);
        c.aligned.assign(values.begin(), values.end());
        return c;
    });
}

TEST(Archive, RoundTrip) {
    EXPECT_EQ(contents_of(body_of(example())), example());
    const Contents empty{0.0, {}, "", {}, {}, {0, 0, 0}};
    EXPECT_EQ(contents_of(body_of(empty)), empty);
    const std::string archive = sealed(kKind, body_of(example()));
    const auto body = unsealed(archive, kKind);
    ASSERT_TRUE(body);
    EXPECT_EQ(*body, body_of(example()));
}

TEST(Archive, EveryTruncationIsRefused) {
    const std::string body = body_of(example());
    for (std::size_t size = 0; size < body.size(); ++size)
        EXPECT_FALSE(contents_of(std::string_view(body).substr(0, size))) << size;
    EXPECT_FALSE(contents_of(body + '\0')) << "a byte too many";
    const std::string archive = sealed(kKind, body);
    for (std::size_t size = 0; size < archive.size(); ++size)
        EXPECT_FALSE(unsealed(std::string_view(archive).substr(0, size), kKind)) << size;
    EXPECT_FALSE(unsealed(archive + '\0', kKind)) << "a byte too many";
}

TEST(Archive, EveryFlippedByteIsRefused) {
    const TemporaryFolder folder;
    const std::string archive = sealed(kKind, body_of(example()));
    for (std::size_t i = 0; i < archive.size(); ++i) {
        std::string bad = archive;
        bad[i] = static_cast<char>(bad[i] ^ 0x10);
        EXPECT_FALSE(unsealed(bad, kKind)) << i;
        write_text(folder / "bad", bad);
        EXPECT_FALSE(read_archive(folder / "bad", kKind)) << i;
    }
}

// Without a seal, damage reaches the reader: it may return nonsense but stays within the
// bytes.
TEST(Archive, FlippedBytesOfABodyAreRefusedOrReadWithinBounds) {
    const std::string body = body_of(example());
    for (std::size_t i = 0; i < body.size(); ++i) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string bad = body;
            bad[i] = static_cast<char>(bad[i] ^ (1 << bit));
            contents_of(bad);
        }
    }
}

TEST(Archive, AHugeCountAllocatesNothing) {
    for (const std::uint64_t count : {std::uint64_t{1} << 60, ~std::uint64_t{0},
                                      std::uint64_t{1} << 32, std::uint64_t{3}}) {
        const std::string body = archive_of([&](ArchiveWriter& out) {
            out.value(count);
            out.value('x');
        });
        EXPECT_FALSE(read_back(body, [](ArchiveReader& in) { return in.text(); }));
        EXPECT_FALSE(
            read_back(body, [](ArchiveReader& in) { return in.vector<Point>(); }));
        EXPECT_FALSE(read_back(body, [&](ArchiveReader& in) {
            return in.values<std::uint64_t>(in.value<std::uint64_t>()).size();
        }));
    }
    for (const auto& [width, height] :
         {std::pair{1 << 30, 1 << 30}, {0x7fffffff, 0x7fffffff}, {-1, -1}, {-1, 1}}) {
        const std::string body = archive_of([&](ArchiveWriter& out) {
            out.value(std::int32_t{width});
            out.value(std::int32_t{height});
        });
        EXPECT_FALSE(
            read_back(body, [](ArchiveReader& in) { return in.field<Point>(); }));
    }
}

TEST(Archive, ANumberAboveItsLimitIsRefused) {
    const std::string body = archive_of([](ArchiveWriter& out) { out.value(9u); });
    const auto limited_to = [&](std::uint32_t limit) {
        return read_back(
            body, [&](ArchiveReader& in) { return in.at_most<std::uint32_t>(limit); });
    };
    EXPECT_EQ(limited_to(9), 9u);
    EXPECT_FALSE(limited_to(8));
}

TEST(Archive, Files) {
    const TemporaryFolder folder;
    const std::string body = body_of(example());
    write_archive(folder / "a", kKind, body);
    EXPECT_EQ(read_archive(folder / "a", kKind), body);
    EXPECT_EQ(read_text(folder / "a"), sealed(kKind, body));
    EXPECT_FALSE(read_archive(folder / "a", "cydonia archive test 2\n"));
    EXPECT_FALSE(read_archive(folder / "a", "cydonia"));
    EXPECT_FALSE(read_archive(folder / "missing", kKind));
    EXPECT_FALSE(read_archive(folder.path(), kKind));
    write_archive(folder / "empty", kKind, "");
    EXPECT_EQ(read_archive(folder / "empty", kKind), "");
}

TEST(Archive, FullDisk) {
    const TemporaryFolder folder;
    write_archive(folder / "a", kKind, "old");
    {
        const SmallDisk disk(4096);
        expect_error(ExitCode::kFailed, "a: File too large", [&] {
            write_archive(folder / "a", kKind, std::string(1 << 20, 'x'));
        });
    }
    EXPECT_EQ(read_archive(folder / "a", kKind), "old");
}

}  // namespace
}  // namespace cydonia
