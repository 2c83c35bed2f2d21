// How much the light of a sequence flickers: flicker FRAMES_FOLDER NAME. Each frame is
// carried to the next along its motion pass; what is then left of a difference, in blocks
// of 16x16 pixels that hold land only, is flicker (blotches of radiosity are as large or
// larger; finer differences are those of sampling another place).
#include <OpenImageIO/imageio.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "field/error.h"
#include "field/image.h"

namespace {

namespace fs = std::filesystem;
using namespace cydonia;

constexpr int kBlock = 16;

struct Motion {
    int width = 0, height = 0;
    std::vector<float> xy, depth;
};

Motion motion_of(const fs::path& file) {
    const auto in = OIIO::ImageInput::open(file.string());
    if (!in) throw failure("cannot read {}", file.string());
    Motion motion;
    for (int part = 0; in->seek_subimage(part, 0); ++part) {
        const OIIO::ImageSpec& spec = in->spec();
        const auto pixels = static_cast<std::size_t>(spec.width * spec.height);
        motion.width = spec.width, motion.height = spec.height;
        const std::string first = spec.channelnames.front();
        if (first == "motion.X") {
            motion.xy.resize(2 * pixels);
            in->read_image(part, 0, 0, 2, OIIO::TypeFloat, motion.xy.data());
        } else if (first == "Z") {
            motion.depth.resize(pixels);
            in->read_image(part, 0, 0, 1, OIIO::TypeFloat, motion.depth.data());
        }
    }
    if (motion.xy.empty() || motion.depth.empty())
        throw failure("{} needs the passes depth and motion", file.string());
    return motion;
}

float green(const Field<Rgb>& frame, double x, double y) {
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const auto u = static_cast<float>(x - i), v = static_cast<float>(y - j);
    const auto at = [&](int a, int b) { return frame(i + a, j + b)[1]; };
    return (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) +
           v * ((1 - u) * at(0, 1) + u * at(1, 1));
}

// Relative differences of all whole blocks.
void compare(const Field<Rgb>& now, const Motion& motion, const Field<Rgb>& next,
             std::vector<double>& differences) {
    const int w = now.width(), h = now.height();
    for (int top = 0; top + kBlock <= h; top += kBlock)
        for (int left = 0; left + kBlock <= w; left += kBlock) {
            double before = 0.0, after = 0.0;
            bool whole = true;
            for (int y = top; whole && y < top + kBlock; ++y)
                for (int x = left; whole && x < left + kBlock; ++x) {
                    const auto i = static_cast<std::size_t>(y * w + x);
                    const double to_x = x + motion.xy[2 * i];
                    const double to_y = y + motion.xy[2 * i + 1];
                    whole = motion.depth[i] < 1e9f && to_x >= 0.0 && to_y >= 0.0 &&
                            to_x < w - 1.0 && to_y < h - 1.0;
                    if (!whole) break;
                    before += now(x, y)[1];
                    after += green(next, to_x, to_y);
                }
            if (whole && before > 0.0)
                differences.push_back(std::abs(after - before) / before);
        }
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 3) throw bad_request("flicker FRAMES_FOLDER NAME");
    const auto file = [&](int i, const char* extension) {
        return fs::path(argv[1]) / fmt::format("{}-{:04}{}", argv[2], i, extension);
    };
    std::vector<double> all;
    for (int i = 1; fs::exists(file(i + 1, ".exr")); ++i)
        compare(read_exr_rgb(file(i, ".exr")), motion_of(file(i, ".passes.exr")),
                read_exr_rgb(file(i + 1, ".exr")), all);
    if (all.empty()) throw failure("no two frames of '{}' in {}", argv[2], argv[1]);
    std::ranges::sort(all);
    double sum = 0.0;
    for (const double d : all) sum += d * d;
    fmt::print("{} blocks: {:.2f} % root mean square, {:.2f} % at the 99th percentile\n",
               all.size(), 100.0 * std::sqrt(sum / static_cast<double>(all.size())),
               100.0 * all[all.size() * 99 / 100]);
} catch (const std::exception& error) {
    fmt::print(stderr, "flicker: {}\n", error.what());
    return 1;
}
