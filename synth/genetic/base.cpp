#include "synth/genetic/base.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synth/genetic/edges.h"

namespace cydonia::genetic {
namespace {

constexpr double kSmooth = 1.0;  // cells

struct Means {
    double height = 0.0, slope = 0.0;
};

Means means_of(const LevelSamples& samples, int type) {
    Means means;
    double cells = 0.0, slopes = 0.0;
    for (const int index : samples.of_type[std::size_t(type)]) {
        const Field<float>& h = samples.all[std::size_t(index)].land->heights;
        for (int y = 0; y < h.height(); ++y)
            for (int x = 0; x < h.width(); ++x) {
                means.height += h(x, y), cells += 1.0;
                if (x == 0 || y == 0) continue;
                means.slope += std::hypot(h(x, y) - h(x - 1, y), h(x, y) - h(x, y - 1)) /
                               samples.spacing;
                slopes += 1.0;
            }
    }
    if (cells > 0.0) means.height /= cells;
    if (slopes > 0.0) means.slope /= slopes;
    return means;
}

// The largest field below the heights whose slopes are no more than `rise` a cell: a
// distance transform in two sweeps (Rosenfeld and Pfaltz 1966).
Field<float> below(Field<float> heights, double rise) {
    const int w = heights.width(), h = heights.height();
    const auto lower = [&](int x, int y, int dx, int dy) {
        if (!heights.contains(x + dx, y + dy)) return;
        const double step = rise * (dx != 0 && dy != 0 ? std::numbers::sqrt2 : 1.0);
        heights(x, y) = std::min(heights(x, y), float(heights(x + dx, y + dy) + step));
    };
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            lower(x, y, -1, 0), lower(x, y, -1, -1), lower(x, y, 0, -1),
                lower(x, y, 1, -1);
    for (int y = h - 1; y >= 0; --y)
        for (int x = w - 1; x >= 0; --x)
            lower(x, y, 1, 0), lower(x, y, 1, 1), lower(x, y, 0, 1), lower(x, y, -1, 1);
    return heights;
}

Field<float> negative(Field<float> field) {
    for (float& value : field) value = -value;
    return field;
}

}  // namespace

Base base_of(const LevelSamples& samples, const Regions& regions) {
    const int w = regions.at.width(), h = regions.at.height();
    std::vector<Means> means(samples.of_type.size());
    double steepest = 1e-3;
    for (const int type : regions.types) {
        means[std::size_t(type)] = means_of(samples, type);
        steepest = std::max(steepest, means[std::size_t(type)].slope);
    }
    Field<float> level(w, h);
    for (std::size_t i = 0; i < level.size(); ++i)
        level[i] =
            float(means[std::size_t(regions.types[std::size_t(regions.at[i])])].height);

    // Half way between the largest land below that is nowhere too steep and the least
    // above: at a step both fall by twice the slope wanted, and their mean by that.
    const double rise = 2.0 * steepest * samples.spacing;
    const Field<float> low = below(level, rise),
                       high = negative(below(negative(level), rise));
    Base base{Field<float>(w, h), Field<float>(w, h, 1.0f), samples};
    for (std::size_t i = 0; i < level.size(); ++i)
        base.pattern[i] = 0.5f * (low[i] + high[i]);
    base.pattern = blurred(base.pattern, kSmooth);

    std::vector<double> most(regions.types.size());
    for (std::size_t i = 0; i < level.size(); ++i) {
        double& m = most[std::size_t(regions.at[i])];
        m = std::max(m, double(std::abs(base.pattern[i] - level[i])));
    }
    for (std::size_t i = 0; i < level.size(); ++i) {
        const double m = most[std::size_t(regions.at[i])];
        // What is off by less than a cell's rise needs no slope.
        const double off = std::abs(base.pattern[i] - level[i]);
        if (m > 0.5 * rise) base.own[i] = float(1.0 - off / m);
    }

    for (Sample& sample : base.samples.all) {
        auto land = std::make_shared<SampleLand>(*sample.land);
        land->detail = land->heights;
        for (float& d : land->detail)
            d = float(d - means[std::size_t(sample.type)].height);
        sample.land = std::move(land);
    }
    return base;
}

}  // namespace cydonia::genetic
