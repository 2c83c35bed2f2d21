#include "synth/sketch/landform.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"
#include "field/random.h"
#include "field/sample.h"
#include "field/smoothstep.h"
#include "synth/sketch/bands.h"
#include "synth/texture/nearest.h"

namespace cydonia::sketch {
namespace {

constexpr double kLeastReach = 2.0;  // samples: of the finest deformations
constexpr int kLastRounds = 4;       // that bring the land onto the silhouette

// A sample of the footprint: where it is along the shadow, and how far from it.
struct Foot {
    std::size_t index;
    float place;     // among the silhouette's values
    float distance;  // samples, from the shadow
    float reach;     // samples, of the boundary
    float noise;     // W_0: how much of the noise is the silhouette's

    // Eq. 1, of a boundary that is a share of its own.
    float weight(float share) const {
        const float a = distance / std::max(share * reach, float(kLeastReach));
        const float b = a * a - 1.0f;
        return a < 1.0f && distance < reach ? b * b : 0.0f;
    }
};

std::vector<Foot> footprint(const Landform& landform, const Field<float>& land,
                            double spacing) {
    const texture::Shape& shadow = landform.shadow;
    const double depth = spacing * land.height(), length = shadow.length();
    const int values = landform.silhouette.width();
    double widest = 0.0;
    for (int i = 0; i < values; ++i) {
        const auto [left, right] = landform.boundary(length * i / (values - 1));
        widest = std::max({widest, left, right});
    }
    const texture::Grid grid{spacing, 0.0, depth, 0, 0, land.width(), land.height()};
    Field<texture::Nearest> nearest(land.width(), land.height());
    texture::add_nearest(shadow, grid, widest, nearest);

    std::vector<Foot> feet;
    for (int y = 0; y < land.height(); ++y)
        for (int x = 0; x < land.width(); ++x) {
            const auto [squared, segment] = nearest(x, y);
            if (segment < 0) continue;
            const auto s = std::size_t(segment);
            const Point2 p = grid.centre(x, y), &a = shadow.points[s],
                         &b = shadow.points[s + 1];
            const double share = texture::nearest_share(a, b, p);
            const double along =
                shadow.along[s] + share * (shadow.along[s + 1] - shadow.along[s]);
            const bool left =
                texture::cross(texture::from_to(a, b), texture::from_to(a, p)) > 0.0;
            const double reach = landform.boundary(along)[left ? 0 : 1];
            const double distance = std::sqrt(squared);
            if (!(distance < reach)) continue;
            Foot foot{nearest.index(x, y), float(along / length * (values - 1)),
                      float(distance / spacing), float(reach / spacing), 0.0f};
            foot.noise = foot.weight(1.0f);
            feet.push_back(foot);
        }
    return feet;
}

float value_at(const Field<float>& line, float place) {
    const int i = std::clamp(int(place), 0, std::max(0, line.width() - 2));
    const float t = place - float(i);
    return line.width() == 1 ? line[0] : (1.0f - t) * line(i, 0) + t * line(i + 1, 0);
}

// Where the shadow is, in samples of the land, for each value of the silhouette.
struct Course {
    std::vector<std::array<double, 2>> places;
    double step;                   // samples from one to the next
    std::array<bool, 2> pinned{};  // to the terrain's edge: nothing to blend into

    Course(const Landform& landform, const Field<float>& land, double spacing) {
        const int values = landform.silhouette.width();
        const double length = landform.shadow.length();
        step = length / spacing / std::max(1, values - 1);
        for (int i = 0; i < values; ++i) {
            const Point2 p = landform.shadow.at(length * i / std::max(1, values - 1));
            places.push_back(
                {p[0] / spacing - 0.5, land.height() - p[1] / spacing - 0.5});
        }
        for (const int end : {0, 1}) {
            const auto [x, y] = end == 0 ? places.front() : places.back();
            pinned[std::size_t(end)] =
                x < 0.5 || y < 0.5 || x > land.width() - 1.5 || y > land.height() - 1.5;
        }
        if (landform.shadow.closed) pinned = {true, true};
    }
    // 0 at the ends, 1 from `width` samples on, without a bend.
    float inside(int i, double width) const {
        const double begin = pinned[0] ? width : step * i,
                     end = pinned[1] ? width : step * (int(places.size()) - 1 - i);
        return float(smoothstep(0.0, width, std::min(begin, end)));
    }
};

// Eq. 3: by what the silhouette is higher than the land with its change so far, along all
// of it.
void pull(Field<float>& change, const Field<float>& land, const Field<float>& silhouette,
          const Course& course, const std::vector<Foot>& feet, float share,
          double width) {
    Field<float> step(silhouette.width(), 1);
    for (int i = 0; i < step.width(); ++i) {
        const auto [x, y] = course.places[std::size_t(i)];
        const float height = bilinear(land, x, y) + bilinear(change, x, y);
        step[std::size_t(i)] =
            course.inside(i, width) * (silhouette[std::size_t(i)] - height);
    }
    parallel_for(int(feet.size()), 4096, [&](int k) {
        const Foot& foot = feet[std::size_t(k)];
        const float weight = foot.weight(share);
        if (weight > 0.0f) change[foot.index] += weight * value_at(step, foot.place);
    });
}

}  // namespace

NoiseLevels noise_of(const Field<float>& silhouette, int levels, bool mouse) {
    const std::vector<Field<float>> scales = smoothed(silhouette, levels);
    NoiseLevels noise;
    for (int i = 1; i <= levels; ++i) {
        double squares = 0.0;
        // Where the filter does not look beyond the ends, which are bent.
        const int n = silhouette.width(), end = std::min(4 << (levels - i), n / 3);
        for (int k = end; k < n - end; ++k) {
            const double d = scales[std::size_t(i)][std::size_t(k)] -
                             scales[std::size_t(i - 1)][std::size_t(k)];
            squares += d * d;
        }
        noise.measured.push_back(std::sqrt(squares / (n - 2 * end)));
    }
    // A line through the logarithms, of bands that have any.
    const int last = levels - (mouse ? 2 : 0);
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (int i = 1; i <= last; ++i) {
        const double sigma = noise.measured[std::size_t(i - 1)];
        if (!(sigma > 1e-4)) continue;
        const double l = std::log(sigma);
        n += 1.0, x += i, y += l, xx += double(i) * i, xy += i * l;
    }
    const double spread = n * xx - x * x;
    const double slope = spread > 0.0 ? (n * xy - x * y) / spread : 0.0;
    for (int i = 1; i <= levels; ++i)
        noise.fitted.push_back(n == 0.0 ? 0.0
                                        : std::exp((y - slope * x) / n + slope * i));
    return noise;
}

void deform(Field<float>& land, double spacing, const Landform& landform, int levels,
            std::uint64_t seed) {
    const std::vector<Foot> feet = footprint(landform, land, spacing);
    if (feet.empty()) return;
    const Course course(landform, land, spacing);
    const std::vector<Field<float>> scales = smoothed(land, levels),
                                    heights = smoothed(landform.silhouette, levels);
    const NoiseLevels noise = noise_of(landform.silhouette, levels, landform.mouse);

    Field<float> change(land.width(), land.height());
    for (int i = 0; i <= levels; ++i) {
        if (i > 0) {
            const Field<float> band =
                wavelet_noise(0, 0, land.width(), land.height(), i, levels, seed);
            const float sigma = float(noise.fitted[std::size_t(i - 1)]);
            const Field<float>&fine = scales[std::size_t(i)],
                  &coarse = scales[std::size_t(i - 1)];
            Field<float> inside(landform.silhouette.width(), 1);
            for (int k = 0; k < inside.width(); ++k)
                inside[std::size_t(k)] = course.inside(k, std::exp2(levels - i));
            // Eq. 2.
            parallel_for(int(feet.size()), 4096, [&](int k) {
                const Foot& foot = feet[std::size_t(k)];
                const float own = fine[foot.index] - coarse[foot.index];
                change[foot.index] += foot.noise * value_at(inside, foot.place) *
                                      (sigma * band[foot.index] - own);
            });
        }
        pull(change, scales[std::size_t(i)], heights[std::size_t(i)], course, feet,
             std::exp2(-float(i)), std::exp2(levels - i));
    }
    for (int round = 0; round < kLastRounds; ++round)
        pull(change, land, landform.silhouette, course, feet, 0.0f, 1.0);
    for (const Foot& foot : feet) land[foot.index] += change[foot.index];
}

}  // namespace cydonia::sketch
