#include "synth/detail/layers.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "field/error.h"
#include "field/image.h"
#include "field/strokes.h"

namespace cydonia::detail {
namespace {

cv::Mat matrix_of(Field<float>& field) {
    return {field.height(), field.width(), CV_32F, field.row(0).data()};
}

// Turns edges into ramps of about `width` samples.
void soften(Field<float>& share, double width) {
    const int side = 2 * int(width / 4.0) + 1;
    cv::Mat image = matrix_of(share);
    for (int pass = 0; pass < 2; ++pass)
        cv::blur(image, image, {side, side}, {-1, -1}, cv::BORDER_REPLICATE);
}

// The corners of a mapping in the land, in samples from the north-west.
std::vector<std::array<double, 2>> outline_of(const Mapping& m, int width, int height) {
    std::vector<std::array<double, 2>> corners = m.outline;
    if (corners.empty()) {
        const double east = 0.5 * m.size[0], north = 0.5 * m.size[1];
        corners = {{m.to[0] - east, m.to[1] - north},
                   {m.to[0] + east, m.to[1] - north},
                   {m.to[0] + east, m.to[1] + north},
                   {m.to[0] - east, m.to[1] + north}};
    }
    for (auto& [x, y] : corners) x *= width, y = (1.0 - y) * height;
    return corners;
}

struct Box {
    double west, east, north, south;
};
Box box_of(const std::vector<std::array<double, 2>>& corners) {
    Box box{corners[0][0], corners[0][0], corners[0][1], corners[0][1]};
    for (const auto& [x, y] : corners) {
        box.west = std::min(box.west, x), box.east = std::max(box.east, x);
        box.north = std::min(box.north, y), box.south = std::max(box.south, y);
    }
    return box;
}

// Refuses a mapping that leaves its target by more than half a cell of rounding.
Layer layer_of(const Options& options, std::size_t number,
               std::span<const Example> examples, int width, int height) {
    const Mapping& m = options.mappings[number];
    const auto example = std::ranges::find(examples, m.target - 1, &Example::target);
    // The target's size in samples of the land.
    const Field<float>& finest = example->levels[0].details.columns;
    const double across = std::ldexp(finest.width(), example->first),
                 down =
                     std::ldexp(example->levels[0].coarse.height(), example->first + 1);
    const auto corners = outline_of(m, width, height);
    const Box box = box_of(corners);
    const double grain = std::ldexp(1.0, options.levels);
    const auto whole = [&](double samples) {
        return int(grain * std::round(samples / grain));
    };
    const int dx = whole(m.from[0] * across - 0.5 * (box.west + box.east)),
              dy = whole((1.0 - m.from[1]) * down - 0.5 * (box.north + box.south));
    const auto leaves = [&](double begin, double end, double size, double most) {
        return begin < -grain || end > size + grain || end - begin > most + grain;
    };
    if (leaves(box.west + dx, box.east + dx, across, across) ||
        leaves(box.north + dy, box.south + dy, down, down))
        throw bad_request(
            "mapping {} takes {:.0f} x {:.0f} of the land's samples around [{:g}, {:g}] "
            "of {}, which has {:.0f} x {:.0f}: make it smaller, or move `from`",
            number + 1, box.east - box.west, box.south - box.north, m.from[0], m.from[1],
            options.targets[std::size_t(m.target - 1)].source.name(), across, down);

    constexpr int kParts = 16;  // subpixels of a sample
    std::vector<cv::Point> polygon;
    for (const auto& [x, y] : corners)
        polygon.emplace_back(int(std::lround((x - 0.5) * kParts)),
                             int(std::lround((y - 0.5) * kParts)));
    Layer layer{Field<float>(width, height), m.target - 1, {{dx, dy}}};
    cv::Mat image = matrix_of(layer.share);
    cv::fillPoly(image, std::vector{polygon}, cv::Scalar(1.0), cv::LINE_8, 4);
    return layer;
}

std::vector<Layer> painted(const Options& options, int width, int height) {
    std::vector<std::array<std::uint8_t, 3>> palette;
    std::vector<int> targets;
    for (std::size_t i = 0; i < options.targets.size(); ++i)
        if (options.targets[i].colour) {
            palette.push_back(*options.targets[i].colour);
            targets.push_back(int(i));
        }
    const Field<Rgba8> drawn = read_strokes(*options.paint, width, height, palette);
    std::vector<Layer> layers;
    for (std::size_t c = 0; c < palette.size(); ++c) {
        Layer layer{Field<float>(width, height), targets[c], {}};
        bool any = false;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const Rgba8 p = drawn[i];
            const bool is = p[3] != 0 && palette[c][0] == p[0] && palette[c][1] == p[1] &&
                            palette[c][2] == p[2];
            layer.share[i] = is ? 1.0f : 0.0f;
            any |= is;
        }
        if (any) layers.push_back(std::move(layer));
    }
    return layers;
}

}  // namespace

double block_side(const Options& options, int width, int height) {
    return options.block * 0.5 * (width + height);
}

std::vector<Layer> layers_of(const Options& options, std::span<const Example> examples,
                             int width, int height) {
    if (options.mappings.empty() && !options.paint) return {Layer{}};
    std::vector<Layer> layers;
    if (options.paint) layers = painted(options, width, height);
    for (std::size_t i = 0; i < options.mappings.size(); ++i)
        layers.push_back(layer_of(options, i, examples, width, height));
    const double ramp = std::max(block_side(options, width, height) / 2.0,
                                 std::ldexp(1.0, options.levels));
    for (Layer& layer : layers) soften(layer.share, ramp);
    for (std::size_t i = layers.size() - options.mappings.size(); i < layers.size(); ++i)
        for (std::size_t below = 0; below < i; ++below)
            for (std::size_t k = 0; k < layers[i].share.size(); ++k)
                layers[below].share[k] *= 1.0f - layers[i].share[k];
    return layers;
}

}  // namespace cydonia::detail
