#include "field/checked_file.h"

#include <xxhash.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "field/error.h"
#include "field/files.h"

namespace cydonia {

namespace fs = std::filesystem;

void write_checked(const fs::path& file, std::string_view kind, std::string_view body) {
    const std::uint64_t checksum = XXH3_64bits(body.data(), body.size());
    write_atomically(file, [&](const fs::path& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        out << kind;
        out.write(reinterpret_cast<const char*>(&checksum), sizeof checksum);
        out.write(body.data(), static_cast<std::streamsize>(body.size()));
        out.close();
        if (!out)
            throw failure("cannot write {}: {}", file.string(), std::strerror(errno));
    });
}

std::optional<std::string> read_checked(const fs::path& file, std::string_view kind) {
    std::error_code none;
    const std::uintmax_t size = fs::file_size(file, none);
    std::uint64_t checksum = 0;
    const std::size_t head = kind.size() + sizeof checksum;
    if (none || size < head) return std::nullopt;

    std::ifstream in(file, std::ios::binary);
    std::string start(head, '\0'), body(size - head, '\0');
    if (!in.read(start.data(), std::ssize(start)) ||
        !in.read(body.data(), std::ssize(body)))
        return std::nullopt;
    std::memcpy(&checksum, start.data() + kind.size(), sizeof checksum);
    if (!start.starts_with(kind) || XXH3_64bits(body.data(), body.size()) != checksum)
        return std::nullopt;
    return body;
}

}  // namespace cydonia
