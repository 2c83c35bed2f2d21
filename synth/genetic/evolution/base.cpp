#include "synth/genetic/evolution/base.h"

#include <algorithm>
#include <cmath>

namespace cydonia::genetic {
namespace {

constexpr double kLeastReach = 0.5;   // cells; see reach
constexpr double kMostReach = 0.3;    // share of a region's side
constexpr double kLevelSlope = 1e-3;  // slope that level land counts with
constexpr double kLeastOwn = 0.3;     // share of a chunk's relief beside another type
constexpr int kSweeps = 300;
constexpr double kRelaxation = 1.8;

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
    means.slope = std::max(kLevelSlope, slopes > 0.0 ? means.slope / slopes : 0.0);
    return means;
}

// The distance from its boundary at which a region has the mean height of its type: about
// as far as slopes between neighbours need, which are as steep as their land. Each region
// keeps some land at its own height.
std::vector<double> reaches_of(const Regions& regions, const std::vector<Means>& means,
                               double spacing) {
    std::vector<double> reaches(regions.types.size(), kLeastReach * spacing);
    const auto meet = [&](int a, int b) {
        if (a == b) return;
        const Means &ma = means[std::size_t(regions.types[std::size_t(a)])],
                    &mb = means[std::size_t(regions.types[std::size_t(b)])];
        const double reach = std::abs(ma.height - mb.height) / (ma.slope + mb.slope);
        for (const int r : {a, b})
            reaches[std::size_t(r)] = std::max(reaches[std::size_t(r)], reach);
    };
    for (int y = 0; y < regions.at.height(); ++y)
        for (int x = 0; x < regions.at.width(); ++x) {
            if (x > 0) meet(regions.at(x - 1, y), regions.at(x, y));
            if (y > 0) meet(regions.at(x, y - 1), regions.at(x, y));
        }
    for (std::size_t r = 0; r < reaches.size(); ++r)
        reaches[r] = std::min(
            reaches[r],
            std::max(kLeastReach, kMostReach * std::sqrt(double(regions.cells[r]))) *
                spacing);
    return reaches;
}

// Heights that equal the region's mean far inside and slope between neighbours, mostly on
// the side of the steeper one. They solve div(k grad h) = k (h - mean) / reach^2 with k =
// 1 / slope, so that the slopes on both sides of a boundary are those of their land.
// Solved by successive over-relaxation.
Field<float> sloped(const Field<float>& level, const Regions& regions,
                    const std::vector<Means>& means, double spacing) {
    const int w = level.width(), h = level.height();
    const std::vector<double> reaches = reaches_of(regions, means, spacing);
    const auto stiffness = [&](int x, int y) {
        return 1.0 /
               means[std::size_t(regions.types[std::size_t(regions.at(x, y))])].slope;
    };
    Field<float> result = level;
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                const double own = stiffness(x, y);
                const double reach = reaches[std::size_t(regions.at(x, y))] / spacing;
                const double held = own / (reach * reach);
                double sum = held * level(x, y), weights = held;
                const auto add = [&](int i, int j) {
                    if (!level.contains(i, j)) return;
                    const double k = 2.0 / (1.0 / own + 1.0 / stiffness(i, j));
                    sum += k * result(i, j), weights += k;
                };
                add(x - 1, y), add(x + 1, y), add(x, y - 1), add(x, y + 1);
                result(x, y) += float(kRelaxation * (sum / weights - result(x, y)));
            }
    return result;
}

}  // namespace

Base base_of(const LevelSamples& samples, const Regions& regions) {
    const int w = regions.at.width(), h = regions.at.height();
    std::vector<Means> means(samples.of_type.size());
    for (const int type : regions.types)
        means[std::size_t(type)] = means_of(samples, type);
    Field<float> level(w, h);
    for (std::size_t i = 0; i < level.size(); ++i)
        level[i] =
            float(means[std::size_t(regions.types[std::size_t(regions.at[i])])].height);

    Base base{sloped(level, regions, means, samples.spacing), Field<float>(w, h, 1.0f),
              samples};

    std::vector<double> most(regions.types.size());
    for (std::size_t i = 0; i < level.size(); ++i) {
        double& m = most[std::size_t(regions.at[i])];
        m = std::max(m, double(std::abs(base.pattern[i] - level[i])));
    }
    for (std::size_t i = 0; i < level.size(); ++i) {
        const double m = most[std::size_t(regions.at[i])];
        const double off = std::abs(base.pattern[i] - level[i]);
        if (m > 0.0) base.own[i] = float(1.0 - (1.0 - kLeastOwn) * (off / m) * (off / m));
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
