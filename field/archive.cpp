#include "field/archive.h"

#include <xxhash.h>

#include <cerrno>
#include <fstream>

#include "field/error.h"
#include "field/files.h"

namespace cydonia {

namespace fs = std::filesystem;

namespace {

std::size_t bytes_to_next(std::uint64_t at, std::size_t alignment) {
    return (alignment - at % alignment) % alignment;
}

std::uint64_t checksum_of(std::string_view body) {
    return XXH3_64bits(body.data(), body.size());
}

std::string seal_of(std::string_view kind, std::string_view body) {
    const std::uint64_t checksum = checksum_of(body);
    std::string seal(kind);
    seal.append(reinterpret_cast<const char*>(&checksum), sizeof checksum);
    return seal;
}

}  // namespace

void ArchiveWriter::align(std::size_t alignment) {
    const std::string zeros(bytes_to_next(size_, alignment), '\0');
    write(zeros.data(), zeros.size());
}

void ArchiveReader::align(std::size_t alignment) { take(bytes_to_next(at_, alignment)); }

std::string sealed(std::string_view kind, std::string body) {
    body.insert(0, seal_of(kind, body));
    return body;
}

std::optional<std::string_view> unsealed(std::string_view archive,
                                         std::string_view kind) {
    const std::size_t head = kind.size() + sizeof(std::uint64_t);
    if (archive.size() < head) return std::nullopt;
    const std::string_view body = archive.substr(head);
    if (archive.substr(0, head) != seal_of(kind, body)) return std::nullopt;
    return body;
}

void write_archive(const fs::path& file, std::string_view kind, std::string_view body) {
    write_atomically(file, [&](const fs::path& temporary) {
        errno = 0;
        std::ofstream out(temporary, std::ios::binary);
        out << seal_of(kind, body);
        out.write(body.data(), static_cast<std::streamsize>(body.size()));
        out.close();
        if (!out)
            throw failure("cannot write {}: {}", file.string(),
                          errno == 0 ? "unknown reason" : std::strerror(errno));
    });
}

std::optional<std::string> read_archive(const fs::path& file, std::string_view kind) {
    std::error_code none;
    const std::uintmax_t size = fs::file_size(file, none);
    const std::size_t head = kind.size() + sizeof(std::uint64_t);
    if (none || size < head) return std::nullopt;

    // Seal and body are read apart, so that a large body is not copied.
    std::ifstream in(file, std::ios::binary);
    std::string seal(head, '\0');
    if (!in.read(seal.data(), std::ssize(seal)) || !seal.starts_with(kind))
        return std::nullopt;
    std::string body(size - head, '\0');
    if (!in.read(body.data(), std::ssize(body)) || seal != seal_of(kind, body))
        return std::nullopt;
    return body;
}

}  // namespace cydonia
