#include "app/pipeline/key.h"

#include <fmt/core.h>
#include <xxhash.h>

#include <system_error>

#include "field/source.h"

namespace cydonia {

Key KeyBuilder::key() const { return hash_of_bytes(bytes_); }

std::uint64_t hash_of_bytes(std::string_view bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

std::uint64_t hash_of_file(const std::filesystem::path& file) {
    std::error_code none;
    return std::filesystem::exists(file, none) ? open_source(file).hash : 0;
}

std::string hex(Key key) { return fmt::format("{:016x}", key); }

}  // namespace cydonia
