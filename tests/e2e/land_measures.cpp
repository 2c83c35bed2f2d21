#include "tests/e2e/land_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "field/strokes.h"

namespace cydonia::test {
namespace {

// Cells joined from the highest down: the classical merge tree.
class Islands {
  public:
    explicit Islands(std::size_t cells) : above_(cells, kSea) {}

    bool stands(std::size_t cell) const { return above_[cell] != kSea; }
    void raise(std::size_t cell) { above_[cell] = cell; }
    std::size_t summit(std::size_t cell) {
        while (above_[cell] != cell) cell = above_[cell] = above_[above_[cell]];
        return cell;
    }
    void join(std::size_t low, std::size_t high) { above_[low] = high; }

  private:
    static constexpr std::size_t kSea = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> above_;
};

template <class Visit>
void for_neighbours(const Field<float>& f, std::size_t cell, Visit visit) {
    const int x = static_cast<int>(cell) % f.width(),
              y = static_cast<int>(cell) / f.width();
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
            if ((i != 0 || j != 0) && f.contains(x + i, y + j))
                visit(f.index(x + i, y + j));
}

std::vector<std::size_t> from_the_highest(const Field<float>& heights) {
    std::vector<std::size_t> order(heights.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&](std::size_t cell) { return heights[cell]; });
    return order;
}

Peak peak_at(const Field<float>& heights, std::size_t cell, float prominence,
             std::size_t parent) {
    const int w = heights.width(), at = static_cast<int>(cell),
              beyond = static_cast<int>(parent);
    return {at % w, at / w, heights[cell], prominence, beyond % w, beyond / w};
}

}  // namespace

std::vector<Peak> peaks_of(const Field<float>& heights, float prominence) {
    const std::vector<std::size_t> order = from_the_highest(heights);
    Islands islands(heights.size());
    std::vector<Peak> peaks;
    for (const std::size_t cell : order) {
        islands.raise(cell);
        for_neighbours(heights, cell, [&](std::size_t other) {
            if (!islands.stands(other)) return;
            std::size_t low = islands.summit(other), high = islands.summit(cell);
            if (low == high) return;
            if (heights[low] > heights[high]) std::swap(low, high);
            const float rise = heights[low] - heights[cell];
            if (rise >= prominence && rise > 0.0f)
                peaks.push_back(peak_at(heights, low, rise, high));
            islands.join(low, high);
        });
    }
    const std::size_t highest = order.front(), lowest = order.back();
    peaks.push_back(
        peak_at(heights, highest, heights[highest] - heights[lowest], highest));
    std::ranges::stable_sort(peaks, std::ranges::greater{}, &Peak::height);
    return peaks;
}

std::vector<Peak> pits_of(const Field<float>& heights, float depth) {
    Field<float> turned = heights;
    for (float& h : turned) h = -h;
    std::vector<Peak> pits = peaks_of(turned, depth);
    for (Peak& pit : pits) pit.height = -pit.height;
    return pits;
}

Field<float> slopes_of(const Terrain& terrain) {
    const Field<float>& h = terrain.heights;
    const auto run = static_cast<float>(2.0 * terrain.spacing);
    Field<float> slopes(h.width(), h.height());
    for (int y = 1; y + 1 < h.height(); ++y)
        for (int x = 1; x + 1 < h.width(); ++x) {
            const float rise =
                std::hypot(h(x + 1, y) - h(x - 1, y), h(x, y + 1) - h(x, y - 1));
            slopes(x, y) = std::atan(rise / run) * 180.0f / std::numbers::pi_v<float>;
        }
    return slopes;
}

Field<std::uint8_t> drawn(const Source& picture, const Field<float>& shape) {
    const Field<Rgba8> strokes = read_strokes(picture, shape.width(), shape.height());
    Field<std::uint8_t> cells(shape.width(), shape.height());
    for (int y = 0; y < shape.height(); ++y)
        for (int x = 0; x < shape.width(); ++x) cells(x, y) = strokes(x, y)[3] != 0;
    return cells;
}

// Two sweeps, each passing on the distances of the four neighbours behind it.
Field<float> distances_to(const Field<std::uint8_t>& cells, double spacing) {
    const int w = cells.width(), h = cells.height();
    Field<float> far(w, h, std::numeric_limits<float>::infinity());
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            if (cells(x, y)) far(x, y) = 0.0f;
    const auto straight = static_cast<float>(spacing);
    const float slanted = straight * std::numbers::sqrt2_v<float>;
    const auto pass = [&](int x, int y, int turn) {
        constexpr std::array<std::array<int, 2>, 4> kBehind{
            {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
        for (const auto& [i, j] : kBehind) {
            const int u = x + turn * i, v = y + turn * j;
            if (!far.contains(u, v)) continue;
            const float step = i != 0 && j != 0 ? slanted : straight;
            far(x, y) = std::min(far(x, y), far(u, v) + step);
        }
    };
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) pass(x, y, 1);
    for (int y = h - 1; y >= 0; --y)
        for (int x = w - 1; x >= 0; --x) pass(x, y, -1);
    return far;
}

std::vector<float> values_between(const Field<float>& values,
                                  const Field<float>& distances, double least,
                                  double most) {
    std::vector<float> chosen;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (distances[i] > least && distances[i] <= most) chosen.push_back(values[i]);
    return chosen;
}

namespace {

void require(const std::vector<float>& values) {
    if (values.empty()) throw std::invalid_argument("nothing to measure");
}

}  // namespace

double mean_of(const std::vector<float>& values) {
    require(values);
    return std::accumulate(values.begin(), values.end(), 0.0) /
           static_cast<double>(values.size());
}

double deviation_of(const std::vector<float>& values) {
    const double mean = mean_of(values);
    double sum = 0.0;
    for (const float v : values) sum += (v - mean) * (v - mean);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

double quantile_of(std::vector<float> values, double share) {
    require(values);
    const auto place =
        static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::ranges::nth_element(values, values.begin() + place);
    return values[static_cast<std::size_t>(place)];
}

}  // namespace cydonia::test
