#include "render/shadow/check.h"

#include <array>

#include "field/error.h"

namespace cydonia::render {

namespace {

double ratio(std::size_t part, std::size_t whole) {
    return whole == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

ShadowScore score(const Field<std::uint8_t>& cast, const Field<std::uint8_t>& target) {
    const int rays = target.empty() ? 0 : cast.width() / target.width();
    if (rays < 1 || cast.width() != rays * target.width() ||
        cast.height() != rays * target.height())
        throw bad_request("a cast of {}x{} samples does not fit a target of {}x{} cells",
                          cast.width(), cast.height(), target.width(), target.height());
    std::size_t hit = 0, in_cast = 0, in_target = 0;
    for (int y = 0; y < cast.height(); ++y)
        for (int x = 0; x < cast.width(); ++x) {
            const bool c = cast(x, y) != 0, t = target(x / rays, y / rays) != 0;
            hit += c && t;
            in_cast += c;
            in_target += t;
        }
    return {ratio(hit, in_cast + in_target - hit), ratio(hit, in_cast),
            ratio(hit, in_target)};
}

std::vector<ShadowReport> check(const Terrain&, const std::filesystem::path&, Progress&) {
    throw failure("not built yet");
}
std::string advice(const ShadowReport&) { throw failure("not built yet"); }

}  // namespace cydonia::render
