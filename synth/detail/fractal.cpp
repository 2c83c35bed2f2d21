#include "synth/detail/fractal.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"
#include "field/random.h"

namespace cydonia::detail {
namespace {

constexpr int kAround = 4;  // radius over which a scale is estimated, cells

// A number with mean 0 and variance 1: a sum of four uniform numbers, which has the same
// rounding on every machine.
float nearly_normal(std::uint64_t h) {
    constexpr float kMean = 2.0f * 65535.0f, kDeviation = 37837.0f;  // 65536 / sqrt 3
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i) sum += float(h >> (16 * i) & 0xffff);
    return (sum - kMean) / kDeviation;
}

template <class Change>
void change_by_noise(Field<float>& field, int from_x, int from_y, std::uint64_t seed,
                     const Change& change) {
    parallel_for(field.height(), 16, [&](int y) {
        const std::uint64_t row = hash_of({seed, std::uint64_t(from_y + y)});
        for (int x = 0; x < field.width(); ++x)
            change(field(x, y), nearly_normal(mix(row + std::uint64_t(from_x + x))), x,
                   y);
    });
}

}  // namespace

Field<float> strength_of(const Field<float>& values, int around) {
    const int w = values.width(), h = values.height();
    // Summed separately for each value, so that a part equals the whole to the bit.
    const auto mean = [&](int at, int count, auto&& value) {
        const int from = std::max(0, at - around), to = std::min(count - 1, at + around);
        float sum = 0.0f;
        for (int i = from; i <= to; ++i) sum += value(i);
        return sum / float(to - from + 1);
    };
    Field<float> across(w, h), result(w, h);
    parallel_for(h, 16, [&](int y) {
        for (int x = 0; x < w; ++x)
            across(x, y) = mean(x, w, [&](int i) { return values(i, y) * values(i, y); });
    });
    parallel_for(h, 16, [&](int y) {
        for (int x = 0; x < w; ++x)
            result(x, y) = std::sqrt(mean(y, h, [&](int j) { return across(x, j); }));
    });
    return result;
}

void take_scale(Example& example) {
    for (Level& level : example.levels) {
        level.details.columns = strength_of(level.details.columns, kAround);
        level.details.rows = strength_of(level.details.rows, kAround);
    }
}

void make_noise(Details& strengths, const Window& window, std::uint64_t seed, int level) {
    const auto times = [](float& value, float noise, int, int) { value *= noise; };
    const auto of = [&](const char* which) {
        return hash_of({seed, key(which), std::uint64_t(level)});
    };
    change_by_noise(strengths.columns, 2 * window.x, window.y, of("columns"), times);
    change_by_noise(strengths.rows, window.x, window.y, of("rows"), times);
}

double fractal_scale(std::span<const Example> examples, Filter filter, int level,
                     int levels) {
    double squares = 0.0, count = 0.0;
    for (const Example& example : examples) {
        const Level* coarsest = example.level(levels - 1);
        if (!coarsest) continue;
        // The land that the details alone give.
        const Field<float> residuals =
            subdivided(Field<float>(coarsest->coarse.width(), coarsest->coarse.height()),
                       coarsest->details, filter);
        for (const float r : residuals) squares += double(r) * r;
        count += double(residuals.size());
    }
    const double coarsest = count > 0.0 ? std::sqrt(squares / count) : 0.0;
    return coarsest * std::exp2(-kHurst * (levels - 1 - level));
}

void add_noise(Field<float>& land, const Window& window, double strength,
               const Field<float>& share, std::uint64_t seed, int level) {
    change_by_noise(land, window.x, window.y,
                    hash_of({seed, key("addition"), std::uint64_t(level)}),
                    [&](float& height, float noise, int x, int y) {
                        const float here = share.empty() ? 1.0f : share(x, y);
                        height += float(strength) * here * noise;
                    });
}

}  // namespace cydonia::detail
