#include "field/whole.h"

#include <cstdint>
#include <string>

#include "field/files.h"

namespace cydonia {
namespace {

constexpr std::size_t kLargestFile = std::size_t{4} << 30;

// A signature of 8 bytes, then chunks of length, type, data and a checksum; IEND is the
// last.
bool is_whole_png(std::string_view bytes) {
    std::size_t at = 8;
    while (at + 12 <= bytes.size()) {
        if (bytes.substr(at + 4, 4) == "IEND") return true;
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i)
            length = length << 8 | static_cast<std::uint8_t>(bytes[at + i]);
        at += 12 + length;
    }
    return false;
}

// Within a scan 0xff is always escaped, so a scan that ended is one with the end mark
// after it; cameras append what they like after that.
bool is_whole_jpeg(std::string_view bytes) {
    const auto scan = bytes.rfind("\xff\xda");
    const auto end = bytes.rfind("\xff\xd9");
    return scan != bytes.npos && end != bytes.npos && end > scan;
}

}  // namespace

bool is_whole(const std::filesystem::path& path, std::string_view format) {
    if (format == "png") return is_whole_png(read_text(path, kLargestFile));
    if (format == "jpeg") return is_whole_jpeg(read_text(path, kLargestFile));
    return true;
}

}  // namespace cydonia
