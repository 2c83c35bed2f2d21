#include "synth/statistics/water.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "synth/statistics/windowed.h"

namespace cydonia::statistics {
namespace {

constexpr std::size_t kLeastSamples = 200;  // samples of one height in a body of water
constexpr std::size_t kBroad = 64;   // of them whose surroundings have that height, too
constexpr int kRadius = 2;           // samples: how far the surroundings reach
constexpr float kLevel =
    1e-3f;  // metres: the difference that warping leaves within one height

}  // namespace

Field<std::uint8_t> water_of(const Field<float>& heights) {
    const int w = heights.width(), h = heights.height();
    Field<std::uint8_t> water(w, h);
    const Field<float> low = window_low(heights, kRadius),
                       high = window_high(heights, kRadius);
    // At the land's sides it is not known how broad a level band is.
    const auto amid = [&](std::size_t i) {
        const int x = int(i % std::size_t(w)), y = int(i / std::size_t(w));
        return high[i] - low[i] <= kLevel && x >= kRadius && y >= kRadius &&
               x + kRadius < w && y + kRadius < h;
    };
    std::vector<bool> seen(heights.size());
    std::vector<std::size_t> area;
    for (std::size_t start = 0; start < heights.size(); ++start) {
        if (seen[start] || !amid(start)) continue;
        // Fills from samples with level surroundings only, so that little dry land is
        // visited. Heights are compared with that of the first sample, which OpenCV's
        // connectedComponents cannot do.
        area.assign(1, start);
        seen[start] = true;
        std::size_t broad = 0;
        const auto visit = [&](std::size_t to) {
            if (seen[to] || std::abs(heights[to] - heights[start]) > kLevel) return;
            seen[to] = true;
            area.push_back(to);
        };
        for (std::size_t next = 0; next < area.size(); ++next) {
            const std::size_t i = area[next];
            const int x = int(i % std::size_t(w)), y = int(i / std::size_t(w));
            broad += amid(i);
            if (x > 0) visit(i - 1);
            if (x + 1 < w) visit(i + 1);
            if (y > 0) visit(i - std::size_t(w));
            if (y + 1 < h) visit(i + std::size_t(w));
        }
        if (area.size() >= kLeastSamples && broad >= kBroad)
            for (const std::size_t i : area) water[i] = 1;
    }
    return water;
}

Field<std::uint8_t> grown(const Field<std::uint8_t>& mask, int samples) {
    Field<float> shares(mask.width(), mask.height());
    std::ranges::copy(mask, shares.begin());
    shares = window_high(shares, samples);
    Field<std::uint8_t> result(mask.width(), mask.height());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = shares[i] > 0.0f;
    return result;
}

Field<std::uint8_t> touched(const Field<std::uint8_t>& mask, double cell, int width,
                            int height) {
    Field<std::uint8_t> result(width, height);
    const auto begin = [&](int i, int n) {
        return std::min(int(i * cell + 1e-6), n - 1);
    };
    const auto end = [&](int i, int n) {
        return std::clamp(int(std::ceil((i + 1) * cell - 1e-6)), begin(i, n) + 1, n);
    };
    for (int y = 0; y < height; ++y)
        for (int q = begin(y, mask.height()); q < end(y, mask.height()); ++q)
            for (int x = 0; x < width; ++x)
                for (int p = begin(x, mask.width()); p < end(x, mask.width()); ++p)
                    result(x, y) |= mask(p, q);
    return result;
}

}  // namespace cydonia::statistics
