#include "synth/statistics/measures.h"

#include <cmath>
#include <limits>

#include "field/parallel.h"
#include "field/vec.h"
#include "synth/statistics/edges.h"
#include "synth/statistics/ridges.h"
#include "synth/statistics/windowed.h"

namespace cydonia::statistics {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
// Radii of windows in samples. A window for relief, directions and bands spans two waves
// of the coarsest band, one for densities several features.
constexpr int kRadius = 8, kWide = 16;
// Larger curvatures, given as the change of slope from sample to sample, count by their
// logarithm; otherwise a few cliffs would outweigh all other land in the higher moments.
constexpr float kCalm = 0.01f;
// Windows more level than this have no direction and no spectrum.
constexpr float kLevel = 1e-8f;  // square of slope

struct Surface {
    Field<float> slope, curvature;
    Field<float> ee, nn, en;  // structure tensor: products of the gradient's parts
};

Surface surface_of(const Field<float>& land) {
    const int w = land.width(), h = land.height();
    Surface s;
    s.slope = s.curvature = Field<float>(w, h, kNone);
    s.ee = s.nn = s.en = Field<float>(w, h);
    parallel_for(std::max(0, h - 2), 16, [&](int inner) {
        const int y = inner + 1;
        const float *n = land.row(y - 1).data(), *m = land.row(y).data(),
                    *o = land.row(y + 1).data();
        for (int x = 1; x + 1 < w; ++x) {
            const std::size_t i = land.index(x, y);
            const float p = 0.5f * (m[x + 1] - m[x - 1]), q = 0.5f * (n[x] - o[x]);
            const float pp = p * p, qq = q * q, steep = 1.0f + pp + qq;
            s.slope[i] = float(degrees(std::atan(std::sqrt(double(pp + qq)))));
            const float xx = m[x + 1] - 2.0f * m[x] + m[x - 1],
                        yy = n[x] - 2.0f * m[x] + o[x],
                        xy = 0.25f * (n[x + 1] - n[x - 1] - o[x + 1] + o[x - 1]);
            const float mean = ((1.0f + qq) * xx - 2.0f * p * q * xy + (1.0f + pp) * yy) /
                               (2.0f * steep * std::sqrt(steep));
            s.curvature[i] = std::asinh(mean / kCalm);
            s.ee[i] = pp, s.nn[i] = qq, s.en[i] = p * q;
        }
    });
    return s;
}

// Coherence of the windowed structure tensor, (l1 - l2) / (l1 + l2) of its eigenvalues.
Field<float> directionality(const Surface& surface) {
    const Field<float> ee = window_mean(surface.ee, kRadius),
                       nn = window_mean(surface.nn, kRadius),
                       en = window_mean(surface.en, kRadius);
    Field<float> result(ee.width(), ee.height(), kNone);
    for (std::size_t i = 0; i < result.size(); ++i)
        if (ee[i] + nn[i] > kLevel)
            result[i] =
                std::min(1.0f, std::hypot(ee[i] - nn[i], 2.0f * en[i]) / (ee[i] + nn[i]));
    return result;
}

// Section VII.8 wishes for a finer frequency analysis than comparing coefficients. Here
// it is how much more variance a band holds than the next finer one. Bands are
// differences of the scale space, with deviations below 1, from 1 to 2 and from 2 to 4
// samples. Coarser bands are left to coarser levels of detail.
void add_spectrum(const Field<float>& land, const std::vector<Scale>& scales,
                  Measures& measures) {
    const Field<float>* before = &land;
    Field<float> finer;
    for (const std::size_t k : {0u, 2u, 4u}) {
        if (k >= scales.size()) return;
        Field<float> band(land.width(), land.height());
        for (std::size_t i = 0; i < band.size(); ++i) {
            const float d = (*before)[i] - scales[k].land[i];
            band[i] = d * d;
        }
        band = window_mean(band, kRadius);
        if (!finer.empty()) {
            Field<float>& ratio =
                measures.fields
                    .emplace_back(Quantity::kSpectrum,
                                  Field<float>(land.width(), land.height(), kNone))
                    .second;
            parallel_for(band.height(), 16, [&](int y) {
                for (std::size_t i = band.index(0, y), x = 0;
                     x < std::size_t(band.width()); ++x, ++i)
                    if (finer[i] > kLevel * kLevel && band[i] > kLevel * kLevel)
                        ratio[i] = std::log2(band[i] / finer[i]);
            });
        }
        finer = std::move(band);
        before = &scales[k].land;
    }
}

Field<float> density(const std::vector<Feature>& features, int width, int height) {
    Field<float> marks(width, height);
    for (const Feature& feature : features)
        for (const std::uint32_t i : feature.samples) marks[i] = 100.0f;
    return window_mean(marks, kWide);
}

}  // namespace

Measures measures_of(const Terrain& terrain) {
    using enum Quantity;
    const int w = terrain.heights.width(), h = terrain.heights.height();
    Measures measures;
    if (terrain.heights.empty()) return measures;
    // Heights are divided by the spacing, so that differences of samples are slopes.
    Field<float> land = terrain.heights;
    for (float& height : land) height = float(height / terrain.spacing);
    const std::vector<Scale> scales = scale_space(land);

    Ridges ridges = ridges_of(scales, terrain.spacing);
    const auto add = [&](Quantity first, std::vector<Feature> features) {
        measures.fields.emplace_back(Quantity(int(first) + 3), density(features, w, h));
        measures.kinds.push_back({{{first, &Feature::scale},
                                   {Quantity(int(first) + 1), &Feature::length},
                                   {Quantity(int(first) + 2), &Feature::strength}},
                                  std::move(features)});
    };
    add(kEdgeScale, edges_of(scales, terrain.spacing));
    add(kRidgeScale, std::move(ridges.ridges));
    add(kValleyScale, std::move(ridges.valleys));
    measures.fields.emplace_back(kPeakDensity, density(ridges.peaks, w, h));
    measures.kinds.push_back(
        {{{kPeakScale, &Feature::scale}, {kPeakStrength, &Feature::strength}},
         std::move(ridges.peaks)});

    Surface surface = surface_of(land);
    measures.fields.emplace_back(kElevation, terrain.heights);
    measures.fields.emplace_back(kDirectionality, directionality(surface));
    measures.fields.emplace_back(kSlope, std::move(surface.slope));
    measures.fields.emplace_back(kCurvature, std::move(surface.curvature));
    Field<float> relief = window_high(terrain.heights, kRadius);
    const Field<float> low = window_low(terrain.heights, kRadius);
    for (std::size_t i = 0; i < relief.size(); ++i) relief[i] -= low[i];
    measures.fields.emplace_back(kRelief, std::move(relief));
    add_spectrum(land, scales, measures);
    return measures;
}

}  // namespace cydonia::statistics
