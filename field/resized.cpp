#include <algorithm>
#include <cmath>
#include <vector>

#include "field/error.h"
#include "field/image.h"
#include "field/parallel.h"

namespace cydonia {
namespace {

// The weights of the input samples first, first + 1, ... in one output sample. They sum
// to 1.
struct Window {
    int first = 0;
    std::vector<double> weights;
};

// For shrinking: the share of each input cell that the output cell covers.
Window covered(int i, int from, int to) {
    const double begin = double(i) * from / to;
    const double end = double(i + 1) * from / to;
    Window window{static_cast<int>(begin), {}};
    for (int j = window.first; j < from && j < end; ++j)
        window.weights.push_back((std::min(end, j + 1.0) - std::max(begin, double(j))) /
                                 (end - begin));
    return window;
}

// For growing: linear between the two nearest centres, constant beyond the outermost
// ones.
Window between(int i, int from, int to) {
    const double at = std::clamp((i + 0.5) * from / to - 0.5, 0.0, from - 1.0);
    const int first = std::min(static_cast<int>(at), std::max(from - 2, 0));
    if (from == 1) return {0, {1.0}};
    return {first, {1.0 - (at - first), at - first}};
}

std::vector<Window> windows(int from, int to) {
    std::vector<Window> result;
    for (int i = 0; i < to; ++i)
        result.push_back(to < from ? covered(i, from, to) : between(i, from, to));
    return result;
}

// Resamples every row. The result is transposed, so that two calls resample both axes.
Field<float> resized_across(const Field<float>& image, int width) {
    Field<float> result(image.height(), width);
    const std::vector<Window> columns = windows(image.width(), width);
    parallel_for(image.height(), 16, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const Window& window = columns[std::size_t(x)];
            double sum = 0.0;
            for (std::size_t k = 0; k < window.weights.size(); ++k)
                sum += window.weights[k] * double(image(window.first + int(k), y));
            result(y, x) = static_cast<float>(sum);
        }
    });
    return result;
}

}  // namespace

Field<float> resized(const Field<float>& image, int width, int height) {
    assert(!image.empty() && width > 0 && height > 0);
    if (image.width() == width && image.height() == height) return image;
    return resized_across(resized_across(image, width), height);
}

Field<float> at_most(const Field<float>& image, int samples) {
    assert(samples >= 2);
    const int longer = std::max(image.width(), image.height());
    if (longer <= samples) return image;
    const auto scaled = [&](int side) {
        return std::max(std::min(2, side),
                        static_cast<int>(std::lround(double(side) * samples / longer)));
    };
    return resized(image, scaled(image.width()), scaled(image.height()));
}

}  // namespace cydonia
