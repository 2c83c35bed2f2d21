#include "synth/sketch/bands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "field/parallel.h"
#include "field/random.h"

namespace cydonia::sketch {
namespace {

// The least-squares analysis filter of quadratic B-splines, without weights below 1/3000
// (Cook and DeRose 2005, appendix 1).
constexpr std::array<float, 32> kDown = {
    0.000334f, -0.001528f, 0.000410f,  0.003545f, -0.000938f, -0.008233f, 0.002172f,
    0.019120f, -0.005040f, -0.044412f, 0.011655f, 0.103311f,  -0.025936f, -0.243780f,
    0.033979f, 0.655340f,  0.655340f,  0.033979f, -0.243780f, -0.025936f, 0.103311f,
    0.011655f, -0.044412f, -0.005040f, 0.019120f, 0.002172f,  -0.008233f, -0.000938f,
    0.003546f, 0.000410f,  -0.001528f, 0.000334f};
constexpr int kReach = 16;

// Normalised, as the printed filter does not quite sum to 1 and level land must stay
// level.
constexpr float sum_of(const std::array<float, 32>& filter) {
    float sum = 0.0f;
    for (const float f : filter) sum += f;
    return sum;
}
constexpr float kScale = 1.0f / sum_of(kDown);

int mirrored(int at, int count) {
    const int period = 2 * count;
    at = ((at % period) + period) % period;
    return at < count ? at : period - 1 - at;
}

// Halves a line: coarse value i lies between fine values 2 i and 2 i + 1. `line` has
// kReach more values on either side.
void halve(const float* line, std::span<float> to) {
    for (std::size_t i = 0; i < to.size(); ++i) {
        const float* from = line + 2 * i + 1;
        float sum = 0.0f;
        for (std::size_t k = 0; k < kDown.size(); ++k) sum += kDown[k] * from[k];
        to[i] = kScale * sum;
    }
}

Field<float> transposed(const Field<float>& field) {
    Field<float> result(field.height(), field.width());
    parallel_for((field.height() + 31) / 32, 1, [&](int block) {
        for (int x = 0; x < field.width(); ++x)
            for (int y = 32 * block; y < std::min(field.height(), 32 * block + 32); ++y)
                result(y, x) = field(x, y);
    });
    return result;
}

Field<float> rows_halved(const Field<float>& field) {
    const int n = field.width();
    if (n == 1) return field;
    Field<float> result((n + 1) / 2, field.height());
    parallel_for(field.height(), 8, [&](int y) {
        std::vector<float> line(std::size_t(n + 1 + 2 * kReach));
        for (int i = 0; i < int(line.size()); ++i)
            line[std::size_t(i)] = field(mirrored(i - kReach, n), y);
        halve(line.data(), result.row(y));
    });
    return result;
}

// Doubles a line: values of its quadratic B-spline.
Field<float> rows_doubled(const Field<float>& field, int width) {
    const int n = field.width();
    if (width == 1) return field;
    Field<float> result(width, field.height());
    parallel_for(field.height(), 8, [&](int y) {
        const auto from = field.row(y);
        const auto to = result.row(y);
        for (int x = 0; x < width; ++x) {
            const int i = x / 2, beside = mirrored(x % 2 ? i + 1 : i - 1, n);
            to[std::size_t(x)] =
                0.75f * from[std::size_t(i)] + 0.25f * from[std::size_t(beside)];
        }
    });
    return result;
}

// White noise from cell (x, y) on, without what halving keeps of it.
Field<float> finest_band(int x, int y, int width, int height, std::uint64_t seed) {
    constexpr int kAround =
        2 * kReach;  // even like x and y, because cells are halved in pairs
    Field<float> white(width + 2 * kAround, height + 2 * kAround);
    for (int j = 0; j < white.height(); ++j)
        for (int i = 0; i < white.width(); ++i)
            white(i, j) = float(signed_unit(hash_of(
                {seed, std::uint64_t(x + i - kAround), std::uint64_t(y + j - kAround)})));
    const Field<float> wide = doubled(halved(white), white.width(), white.height());
    Field<float> band(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            band(i, j) = white(i + kAround, j + kAround) - wide(i + kAround, j + kAround);
    return band;
}

double mean_square(const Field<float>& field) {
    double sum = 0.0;
    for (const float v : field) sum += double(v) * v;
    return sum / double(field.size());
}

// The mean square of a band of white noise after so many doublings.
double mean_square_doubled(int times) {
    constexpr int kEnough = 3;
    static const std::array<double, kEnough + 1> known = [] {
        std::array<double, kEnough + 1> values{};
        Field<float> band = finest_band(0, 0, 192, 192, key("mean square"));
        for (int i = 0; i <= kEnough; ++i) {
            values[std::size_t(i)] = mean_square(band);
            band = doubled(band, 2 * band.width(), 2 * band.height());
        }
        return values;
    }();
    return known[std::size_t(std::min(times, kEnough))];
}

}  // namespace

Field<float> halved(const Field<float>& field) {
    Field<float> across = rows_halved(field);
    return field.height() == 1 ? across : transposed(rows_halved(transposed(across)));
}

Field<float> doubled(const Field<float>& field, int width, int height) {
    Field<float> down =
        height == 1 ? field : transposed(rows_doubled(transposed(field), height));
    return rows_doubled(down, width);
}

std::vector<Field<float>> smoothed(const Field<float>& field, int levels) {
    std::vector<Field<float>> pyramid{field};
    for (int i = 0; i < levels; ++i) pyramid.push_back(halved(pyramid.back()));
    std::vector<Field<float>> result(std::size_t(levels + 1));
    result.back() = field;
    for (int i = 0; i < levels; ++i) {
        Field<float> smooth = std::move(pyramid[std::size_t(levels - i)]);
        for (int up = levels - i; up-- > 0;) {
            const Field<float>& shape = pyramid[std::size_t(up)];
            smooth = doubled(smooth, shape.width(), shape.height());
        }
        result[std::size_t(i)] = std::move(smooth);
    }
    return result;
}

Field<float> wavelet_noise(int x, int y, int width, int height, int band, int levels,
                           std::uint64_t seed) {
    const int times = levels - band;
    constexpr int kAround = 4;  // at least the cells that doubling looks at
    const auto coarse = [&](int samples) { return (samples >> times) + 2 * kAround + 2; };
    const int left = ((x >> times) - kAround) & ~1, top = ((y >> times) - kAround) & ~1;
    Field<float> noise = finest_band(left, top, coarse(width), coarse(height),
                                     hash_of({seed, key("band"), std::uint64_t(band)}));
    for (int i = 0; i < times; ++i)
        noise = doubled(noise, 2 * noise.width(), 2 * noise.height());
    const int dx = x - (left << times), dy = y - (top << times);
    const float scale = float(1.0 / std::sqrt(mean_square_doubled(times)));
    Field<float> result(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) result(i, j) = scale * noise(i + dx, j + dy);
    return result;
}

}  // namespace cydonia::sketch
