#include "bench/land_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "field/parallel.h"
#include "field/random.h"
#include "field/vec.h"

namespace cydonia::bench {

namespace {

constexpr int kParts = 16;
constexpr double kSide = 2.0 / 3.0;    // of a model, at most: its parts still differ
constexpr double kShared = 1.0 / 3.0;  // of their ground, at most, of parts compared
constexpr std::size_t kStride = 7;     // every seventh cell tells as much

struct Box {
    int x, y, width, height;
};

// At hashed places; the first four in the corners, which share least.
std::vector<Box> boxes(const Field<float>& land, int width, int height,
                       std::uint64_t seed) {
    std::vector<Box> result;
    const int right = land.width() - width, down = land.height() - height;
    for (int i = 0; i < kParts; ++i) {
        const auto at = [&](int most, const char* axis, bool far) {
            if (i < 4) return far ? most : 0;
            const double share = unit(hash_of({seed, key(axis), std::uint64_t(i)}));
            return static_cast<int>(share * (most + 1));
        };
        result.push_back({at(right, "x", i & 1), at(down, "y", i & 2), width, height});
    }
    return result;
}

double shared(const Box& a, const Box& b) {
    const int w = std::min(a.x, b.x) + a.width - std::max(a.x, b.x);
    const int h = std::min(a.y, b.y) + a.height - std::max(a.y, b.y);
    if (w <= 0 || h <= 0) return 0.0;
    return static_cast<double>(w) * h / (static_cast<double>(a.width) * a.height);
}

using Sample = std::vector<float>;  // sorted

Sample thinned(const Field<float>& values) {
    Sample sample;
    for (std::size_t i = 0; i < values.size(); i += kStride) sample.push_back(values[i]);
    std::ranges::sort(sample);
    return sample;
}

// Central differences, one-sided at the edge; degrees.
Sample slopes(const Field<float>& land, double spacing) {
    const int w = land.width(), h = land.height();
    Field<float> result(w, h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const int x0 = std::max(x - 1, 0), x1 = std::min(x + 1, w - 1);
            const int y0 = std::max(y - 1, 0), y1 = std::min(y + 1, h - 1);
            const double east = (land(x1, y) - land(x0, y)) / (spacing * (x1 - x0));
            const double south = (land(x, y1) - land(x, y0)) / (spacing * (y1 - y0));
            result(x, y) =
                static_cast<float>(degrees(std::atan(std::hypot(east, south))));
        }
    return thinned(result);
}

Sample heights_over_mean(Field<float> land) {
    const double mean =
        std::accumulate(land.begin(), land.end(), 0.0) / static_cast<double>(land.size());
    for (float& height : land) height -= static_cast<float>(mean);
    return thinned(land);
}

// Of samples of one size: how far their values must be moved on average.
double distance(const Sample& a, const Sample& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

using Measure = std::function<Sample(const Field<float>&)>;

std::vector<Sample> samples(const Field<float>& land, const std::vector<Box>& boxes,
                            const Measure& measure) {
    std::vector<Sample> result(boxes.size());
    parallel_for(static_cast<int>(boxes.size()), [&](int i) {
        const Box& box = boxes[static_cast<std::size_t>(i)];
        result[static_cast<std::size_t>(i)] =
            measure(part(land, box.x, box.y, box.width, box.height));
    });
    return result;
}

struct Mean {
    double sum = 0.0;
    int count = 0;
    void add(double value) { sum += value, ++count; }
    double value() const { return sum / std::max(count, 1); }
};

double ratio(const std::vector<Sample>& land, const std::vector<Sample>& model,
             const std::vector<Box>& boxes) {
    Mean across, within;
    for (const Sample& a : land)
        for (const Sample& b : model) across.add(distance(a, b));
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (shared(boxes[i], boxes[j]) < kShared)
                within.add(distance(model[i], model[j]));
    return across.value() / within.value();
}

}  // namespace

double relief(const Field<float>& land) {
    const auto [low, high] = std::ranges::minmax_element(land);
    return static_cast<double>(*high) - *low;
}

double pits_per_1000(const Field<float>& land) {
    std::size_t pits = 0;
    for (int y = 1; y + 1 < land.height(); ++y)
        for (int x = 1; x + 1 < land.width(); ++x) {
            bool lowest = true;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    lowest &= (dx == 0 && dy == 0) || land(x, y) < land(x + dx, y + dy);
            pits += lowest;
        }
    return 1000.0 * static_cast<double>(pits) /
           (static_cast<double>(land.width() - 2) * (land.height() - 2));
}

Likeness likeness(const Field<float>& land, const Field<float>& model, double spacing,
                  std::uint64_t seed) {
    const int width = std::min(land.width(), static_cast<int>(kSide * model.width()));
    const int height = std::min(land.height(), static_cast<int>(kSide * model.height()));
    const std::vector<Box> of_land = boxes(land, width, height, seed);
    const std::vector<Box> of_model = boxes(model, width, height, mix(seed));
    const auto likeness_of = [&](const Measure& measure) {
        return ratio(samples(land, of_land, measure), samples(model, of_model, measure),
                     of_model);
    };
    return {likeness_of([&](const Field<float>& p) { return slopes(p, spacing); }),
            likeness_of(heights_over_mean)};
}

}  // namespace cydonia::bench
