#include "synth/sketch/landform.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"
#include "field/random.h"
#include "field/sample.h"
#include "field/smoothstep.h"
#include "synth/sketch/bands.h"

namespace cydonia::sketch {
namespace {

// The number of rounds that bring the land onto the silhouettes. One is not enough,
// because landforms share samples where they meet.
constexpr int kLastRounds = 4, kLastRoundsOfSeveral = 12;

float value_at(const Field<float>& line, float place) {
    const int i = std::clamp(int(place), 0, std::max(0, line.width() - 2));
    const float t = place - float(i);
    return line.width() == 1 ? line[0] : (1.0f - t) * line(i, 0) + t * line(i + 1, 0);
}

// The values along a shadow, spread over its footprint. Where feet are found on the
// shadow itself, the nearest position jumps from one leg of a bend to the other on its
// inner side. There the value is the mean over all positions, weighted by inverse
// distance, which changes gradually and equals the shadow's own value on the shadow
// (Shepard 1968).
class Spread {
  public:
    Spread(const Landform& landform, const std::vector<std::array<double, 2>>& places,
           int width)
        : smooth_(!lies_on_base_line(landform.shadow)), width_(width) {
        if (smooth_)
            for (const auto& [x, y] : places) places_.push_back({float(x), float(y)});
    }
    float operator()(const Field<float>& line, const Foot& foot) const {
        constexpr float kNear = 8.0f;  // positions this much closer together count as one
        if (!smooth_) return value_at(line, foot.place);
        int stride = 1;
        while (float(2 * stride) * kNear < foot.distance) stride *= 2;
        const float x = float(int(foot.index) % width_),
                    y = float(int(foot.index) / width_);
        float sum = 0.0f, weights = 0.0f;
        const int count = int(places_.size());
        for (int k = 0; k < count; k += stride) {
            const float dx = places_[std::size_t(k)][0] - x,
                        dy = places_[std::size_t(k)][1] - y;
            const float squared = dx * dx + dy * dy + 0.05f;
            const float weight = 1.0f / (squared * squared);
            sum += weight * line[std::size_t(k)], weights += weight;
        }
        return sum / weights;
    }

  private:
    bool smooth_;
    int width_;
    std::vector<std::array<float, 2>> places_;
};

// For each value of the silhouette its position on the shadow, in samples of the land.
struct Course {
    std::vector<std::array<double, 2>> places;
    double step;                 // samples from one value to the next
    std::array<bool, 2> pinned;  // ends that have nothing to blend into

    Course(const Landform& landform, const Field<float>& land, double spacing)
        : pinned(landform.goes_on) {
        const int values = landform.silhouette.width();
        const double length = landform.shadow.length();
        step = length / spacing / std::max(1, values - 1);
        for (int i = 0; i < values; ++i) {
            const Point2 p = landform.shadow.at(length * i / std::max(1, values - 1));
            places.push_back(
                {p[0] / spacing - 0.5, land.height() - p[1] / spacing - 0.5});
        }
    }
    // 0 at the ends and 1 from `width` samples on, smooth at both.
    float inside(int i, double width) const {
        const double begin = pinned[0] ? width : step * i,
                     end = pinned[1] ? width : step * (int(places.size()) - 1 - i);
        return float(smoothstep(0.0, width, std::min(begin, end)));
    }
};

// Eq. 3: how much higher the silhouette is than the land with its change so far, along
// the whole shadow.
Field<float> missing(const Field<float>& change, const Field<float>& land,
                     const Field<float>& silhouette, const Course& course, double width) {
    Field<float> step(silhouette.width(), 1);
    for (int i = 0; i < step.width(); ++i) {
        const auto [x, y] = course.places[std::size_t(i)];
        const float height = bilinear(land, x, y) + bilinear(change, x, y);
        step[std::size_t(i)] =
            course.inside(i, width) * (silhouette[std::size_t(i)] - height);
    }
    return step;
}

// Everything that a feature's landforms need while they are made.
struct Works {
    std::span<const Landform> landforms;
    const std::vector<std::vector<Foot>>& feet;
    std::vector<Course> courses = {};
    std::vector<Spread> spreads = {};

    // Raises the land by the amount that the silhouettes in `heights` are higher.
    void pull(Field<float>& change, const Field<float>& land,
              const std::function<const Field<float>&(std::size_t)>& heights, float share,
              double width) const {
        std::vector<Field<float>> steps;
        for (std::size_t k = 0; k < landforms.size(); ++k)
            steps.push_back(missing(change, land, heights(k), courses[k], width));
        for (std::size_t k = 0; k < landforms.size(); ++k)
            parallel_for(int(feet[k].size()), 4096, [&](int f) {
                const Foot& foot = feet[k][std::size_t(f)];
                const float weight = foot.part * foot.weight(share);
                if (weight > 0.0f)
                    change[foot.index] += weight * spreads[k](steps[k], foot);
            });
    }
    void last_rounds(Field<float>& change, const Field<float>& land) const {
        const auto own = [&](std::size_t k) -> const Field<float>& {
            return landforms[k].silhouette;
        };
        const int rounds = landforms.size() > 1 ? kLastRoundsOfSeveral : kLastRounds;
        for (int round = 0; round < rounds; ++round) pull(change, land, own, 0.0f, 1.0);
    }
    void change_land(Field<float>& land, const Field<float>& change) const {
        std::vector<bool> done(land.size());
        for (const auto& of_one : feet)
            for (const Foot& foot : of_one)
                if (!done[foot.index])
                    land[foot.index] += change[foot.index], done[foot.index] = true;
    }
};

Works works_of(std::span<const Landform> landforms,
               const std::vector<std::vector<Foot>>& feet, const Field<float>& land,
               double spacing) {
    Works works{landforms, feet};
    for (const Landform& landform : landforms) {
        works.courses.emplace_back(landform, land, spacing);
        works.spreads.emplace_back(landform, works.courses.back().places, land.width());
    }
    return works;
}

// A line through the logarithms of those bands that have any noise.
std::vector<double> fitted(const std::vector<double>& measured, int last) {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (int i = 1; i <= last; ++i) {
        const double sigma = measured[std::size_t(i - 1)];
        if (!(sigma > 1e-4)) continue;
        const double l = std::log(sigma);
        n += 1.0, x += i, y += l, xx += double(i) * i, xy += i * l;
    }
    const double spread = n * xx - x * x;
    const double slope = spread > 0.0 ? (n * xy - x * y) / spread : 0.0;
    std::vector<double> line;
    for (int i = 1; i <= int(measured.size()); ++i)
        line.push_back(n == 0.0 ? 0.0 : std::exp((y - slope * x) / n + slope * i));
    return line;
}

}  // namespace

NoiseLevels noise_of(const Field<float>& silhouette, int levels, bool mouse) {
    const std::vector<Field<float>> scales = smoothed(silhouette, levels);
    NoiseLevels noise;
    for (int i = 1; i <= levels; ++i) {
        double squares = 0.0;
        // Only where the filter does not look beyond the ends.
        const int n = silhouette.width(), end = std::min(4 << (levels - i), n / 3);
        for (int k = end; k < n - end; ++k) {
            const double d = scales[std::size_t(i)][std::size_t(k)] -
                             scales[std::size_t(i - 1)][std::size_t(k)];
            squares += d * d;
        }
        noise.measured.push_back(std::sqrt(squares / (n - 2 * end)));
    }
    noise.fitted = fitted(noise.measured, levels - (mouse ? 2 : 0));
    return noise;
}

NoiseLevels noise_of_land(const Field<float>& heights, int levels) {
    const std::vector<Field<float>> scales = smoothed(heights, levels);
    NoiseLevels noise;
    for (int i = 1; i <= levels; ++i) {
        const Field<float>&fine = scales[std::size_t(i)],
              &coarse = scales[std::size_t(i - 1)];
        double squares = 0.0;
        for (std::size_t k = 0; k < fine.size(); ++k)
            squares += (fine[k] - coarse[k]) * double(fine[k] - coarse[k]);
        noise.measured.push_back(std::sqrt(squares / double(fine.size())));
    }
    noise.fitted = fitted(noise.measured, levels);
    return noise;
}

Noise wavelets(const Field<float>& land, int levels, std::uint64_t seed) {
    return [width = land.width(), height = land.height(), levels, seed](int band) {
        return wavelet_noise(0, 0, width, height, band, levels, seed);
    };
}

std::vector<std::vector<Foot>> deform(Field<float>& land, double spacing,
                                      std::span<const Landform> landforms, int levels,
                                      const Noise& noise) {
    std::vector<std::vector<Foot>> feet;
    std::vector<std::vector<Field<float>>> heights;
    for (const Landform& landform : landforms) {
        feet.push_back(footprint(landform, land, spacing));
        heights.push_back(smoothed(landform.silhouette, levels));
    }
    share_out(feet, land.size());
    const Works works = works_of(landforms, feet, land, spacing);
    const std::vector<Field<float>> scales = smoothed(land, levels);

    Field<float> change(land.width(), land.height());
    for (int i = 0; i <= levels; ++i) {
        const double width = std::exp2(levels - i);  // phi_i
        if (i > 0) {
            const Field<float> band = noise(i);
            const Field<float>&fine = scales[std::size_t(i)],
                  &coarse = scales[std::size_t(i - 1)];
            for (std::size_t k = 0; k < landforms.size(); ++k) {
                const float sigma = float(landforms[k].noise[std::size_t(i - 1)]);
                Field<float> inside(landforms[k].silhouette.width(), 1);
                for (int v = 0; v < inside.width(); ++v)
                    inside[std::size_t(v)] = works.courses[k].inside(v, width);
                // Eq. 2.
                parallel_for(int(feet[k].size()), 4096, [&](int f) {
                    const Foot& foot = feet[k][std::size_t(f)];
                    const float own = fine[foot.index] - coarse[foot.index];
                    change[foot.index] += foot.part * foot.noise *
                                          value_at(inside, foot.place) *
                                          (sigma * band[foot.index] - own);
                });
            }
        }
        works.pull(
            change, scales[std::size_t(i)],
            [&](std::size_t k) -> const Field<float>& {
                return heights[k][std::size_t(i)];
            },
            std::exp2(-float(i)), width);
    }
    works.last_rounds(change, land);
    works.change_land(land, change);
    return feet;
}

void settle(Field<float>& land, double spacing, std::span<const Landform> landforms,
            const std::vector<std::vector<Foot>>& feet) {
    const Works works = works_of(landforms, feet, land, spacing);
    Field<float> change(land.width(), land.height());
    works.last_rounds(change, land);
    works.change_land(land, change);
}

}  // namespace cydonia::sketch
