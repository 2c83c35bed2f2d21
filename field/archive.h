#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "field/field.h"

namespace cydonia {

// Archives hold our caches: values one after another, in the byte order and layout of the
// machine that wrote them. They are no format for exchange. A sealed archive begins with
// its kind, which is a line of text with a version number, and a checksum of the rest.

// Appends values to an archive.
class ArchiveWriter {
  public:
    // Receives the bytes in order, in portions of any size.
    using Sink = std::function<void(std::string_view)>;

    explicit ArchiveWriter(Sink sink) : sink_(std::move(sink)) {}
    explicit ArchiveWriter(std::string& bytes)
        : sink_([&bytes](std::string_view portion) { bytes.append(portion); }) {}

    template <class T>
    void value(const T& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        write(&v, sizeof v);
    }
    // The values alone, without their count; the reader must know it.
    template <class T>
    void values(std::span<const T> all) {
        static_assert(std::is_trivially_copyable_v<T>);
        write(all.data(), all.size_bytes());
    }
    template <class T>
    void vector(const std::vector<T>& all) {
        value(std::uint64_t{all.size()});
        values(std::span<const T>(all));
    }
    void text(std::string_view all) {
        value(std::uint64_t{all.size()});
        write(all.data(), all.size());
    }
    template <class T>
    void field(const Field<T>& all) {
        value(std::int32_t{all.width()});
        value(std::int32_t{all.height()});
        values(std::span<const T>(all.data(), all.size()));
    }
    // Appends zeros until the number of bytes written is a multiple of `alignment`.
    void align(std::size_t alignment);

    std::uint64_t size() const { return size_; }  // bytes written

  private:
    void write(const void* from, std::size_t count) {
        size_ += count;
        if (count > 0) sink_({static_cast<const char*>(from), count});
    }

    Sink sink_;
    std::uint64_t size_ = 0;
};

// The bytes are not what a writer put there. Whoever reads an archive catches this, best
// through read_back(), and makes the archive again.
struct DamagedArchive {};

// Reads back what an ArchiveWriter wrote, by the same calls in the same order. Every
// count is compared with the bytes that are left before anything is allocated. All
// members throw DamagedArchive.
class ArchiveReader {
  public:
    explicit ArchiveReader(std::string_view bytes) : bytes_(bytes) {}

    static void expect(bool sound) {
        if (!sound) throw DamagedArchive{};
    }

    template <class T>
    T value() {
        static_assert(std::is_trivially_copyable_v<T>);
        T v;
        std::memcpy(&v, take(sizeof v), sizeof v);
        return v;
    }
    // A number that may be no larger than `limit`.
    template <class T>
    T at_most(std::type_identity_t<T> limit) {
        const T v = value<T>();
        expect(v <= limit);
        return v;
    }
    // A view of `count` values within the archive. Their alignment must be right for T:
    // call align() on both sides, and keep the archive itself aligned.
    template <class T>
    std::span<const T> values(std::uint64_t count) {
        static_assert(std::is_trivially_copyable_v<T>);
        expect(count <= left() / sizeof(T));
        const char* from = take(count * sizeof(T));
        expect(reinterpret_cast<std::uintptr_t>(from) % alignof(T) == 0);
        return {reinterpret_cast<const T*>(from), count};
    }
    template <class T>
    std::vector<T> vector() {
        const auto count = value<std::uint64_t>();
        expect(count <= left() / sizeof(T));
        std::vector<T> all(count);
        copy(all.data(), count * sizeof(T));
        return all;
    }
    std::string text() { return std::string(text_view()); }
    // The text where it lies in the archive.
    std::string_view text_view() {
        const auto count = value<std::uint64_t>();
        return {take(count), count};
    }
    template <class T>
    Field<T> field() {
        const auto width = value<std::int32_t>();
        const auto height = value<std::int32_t>();
        expect(width >= 0 && height >= 0);
        const auto cells = std::uint64_t(width) * std::uint64_t(height);
        expect(cells <= left() / sizeof(T));
        Field<T> all(width, height);
        copy(all.data(), cells * sizeof(T));
        return all;
    }
    // Skips the zeros of ArchiveWriter::align().
    void align(std::size_t alignment);

    std::uint64_t left() const { return bytes_.size() - at_; }  // bytes
    bool at_end() const { return left() == 0; }

  private:
    const char* take(std::uint64_t count) {
        expect(count <= left());
        at_ += count;
        return bytes_.data() + (at_ - count);
    }
    void copy(void* to, std::uint64_t count) {
        const char* from = take(count);
        if (count > 0) std::memcpy(to, from, count);
    }

    std::string_view bytes_;
    std::uint64_t at_ = 0;
};

// The bytes that `write(ArchiveWriter&)` writes.
template <class Write>
std::string archive_of(const Write& write) {
    std::string bytes;
    ArchiveWriter out(bytes);
    write(out);
    return bytes;
}
// What `read(ArchiveReader&)` returns; nothing when the bytes are damaged or go on behind
// what it read.
template <class Read>
auto read_back(std::string_view bytes, const Read& read)
    -> std::optional<std::invoke_result_t<Read, ArchiveReader&>> {
    try {
        ArchiveReader in(bytes);
        auto result = read(in);
        ArchiveReader::expect(in.at_end());
        return result;
    } catch (const DamagedArchive&) {
        return std::nullopt;
    }
}

// The body with its kind and checksum before it.
std::string sealed(std::string_view kind, std::string body);
// The body of a sealed archive, a view of it; nothing when the archive is of another
// kind, cut short or damaged.
std::optional<std::string_view> unsealed(std::string_view archive, std::string_view kind);

// Writes the sealed archive to a temporary name and renames it. Throws failure().
void write_archive(const std::filesystem::path& file, std::string_view kind,
                   std::string_view body);
// Reads the body of a sealed archive. Returns nothing when unsealed() would, or when the
// file is missing.
std::optional<std::string> read_archive(const std::filesystem::path& file,
                                        std::string_view kind);

}  // namespace cydonia
