#include "field/flaw.h"

#include <zlib.h>

#include <cstdint>
#include <string>

#include "field/files.h"

namespace cydonia {
namespace {

constexpr std::size_t kLargestFile = std::size_t{4} << 30;
constexpr std::string_view kTruncated = "truncated, the file ends too early";
constexpr std::string_view kDamaged = "damaged, a checksum does not fit";

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<std::uint8_t>(bytes[i]);
    return value;
}

std::uint32_t checksum(std::string_view bytes) {
    return static_cast<std::uint32_t>(
        crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

// A PNG is a signature of 8 bytes, then chunks of length, type, data and a checksum of
// type and data. IEND is the last chunk.
std::string_view flaw_of_png(std::string_view bytes) {
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        const std::size_t length = big_endian(bytes.substr(at));
        if (bytes.size() - at - 12 < length) return kTruncated;
        const std::string_view content = bytes.substr(at + 4, 4 + length);
        if (big_endian(bytes.substr(at + 8 + length)) != checksum(content))
            return kDamaged;
        if (content.starts_with("IEND")) return {};
        at += 12 + length;
    }
    return kTruncated;
}

// Within a scan of a JPEG 0xff is always escaped, so that a complete scan is one that the
// end mark follows. Cameras may append other data after it.
std::string_view flaw_of_jpeg(std::string_view bytes) {
    const auto scan = bytes.rfind("\xff\xda");
    const auto end = bytes.rfind("\xff\xd9");
    const bool ended = scan != bytes.npos && end != bytes.npos && end > scan;
    return ended ? std::string_view{} : kTruncated;
}

}  // namespace

std::string_view flaw_of(const std::filesystem::path& path, std::string_view format) {
    if (format == "png") return flaw_of_png(read_text(path, kLargestFile));
    if (format == "jpeg") return flaw_of_jpeg(read_text(path, kLargestFile));
    return {};
}

}  // namespace cydonia
