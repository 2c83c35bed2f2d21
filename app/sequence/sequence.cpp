#include "app/sequence/sequence.h"

#include <fmt/core.h>

namespace cydonia {

std::string name_of(Kind kind) {
    switch (kind) {
        case Kind::kDay:
            return "day";
        case Kind::kTurntable:
            return "turntable";
        case Kind::kFilm:
            break;
    }
    return "film";
}

std::string frame_name(const std::string& sequence, int index) {
    return fmt::format("{}-{:04}", sequence, index + 1);
}

std::vector<std::size_t> every_tenth(std::size_t count) {
    std::vector<std::size_t> tenth;
    for (std::size_t i = 0; i < count; i += 10) tenth.push_back(i);
    return tenth;
}

}  // namespace cydonia
