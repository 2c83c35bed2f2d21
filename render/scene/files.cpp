#include "render/scene/files.h"

#include <fmt/core.h>

#include <algorithm>

namespace cydonia::render {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_of_name(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           c == '-';
}

}  // namespace

std::string file_of(std::string_view shot, ShotFile file) {
    return fmt::format("{}.{}", shot, name_in(kShotFiles, file));
}

std::string moment_name(std::string_view shot, int number) {
    return fmt::format("{}.s{:03}", shot, number);
}

bool is_shot_name(std::string_view name) {
    const std::size_t stop = std::min(name.find('.'), name.size());
    const std::string_view camera = name.substr(0, stop), moment = name.substr(stop);
    const bool is_moment = moment.size() > 2 && moment.starts_with(".s") &&
                           std::ranges::all_of(moment.substr(2), is_digit);
    return !camera.empty() && camera.size() <= 64 &&
           std::ranges::all_of(camera, is_of_name) && (moment.empty() || is_moment);
}

}  // namespace cydonia::render
