#include "synth/sketch/noise_source.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "field/dem.h"
#include "field/error.h"
#include "synth/detail/detail.h"
#include "synth/sketch/bands.h"
#include "synth/texture/texture.h"

namespace cydonia::sketch {
namespace {

// The bands of a land, scaled to a mean square of 1 under the feature. Wavelets replace
// bands that the land does not have.
Noise bands_of(const Field<float>& land, double spacing,
               const std::vector<Landform>& landforms, int levels, const Noise& plain) {
    const auto scales =
        std::make_shared<const std::vector<Field<float>>>(smoothed(land, levels));
    std::vector<Foot> feet;
    for (const Landform& landform : landforms)
        std::ranges::copy(footprint(landform, land, spacing), std::back_inserter(feet));
    return [scales, feet = std::move(feet), plain](int i) {
        const Field<float>&fine = (*scales)[std::size_t(i)],
              &coarse = (*scales)[std::size_t(i - 1)];
        constexpr double kLeast = 1e-3;  // metres: weaker bands do not exist
        double squares = 0.0, weights = 0.0;
        for (const Foot& foot : feet) {
            const double d = fine[foot.index] - coarse[foot.index];
            squares += foot.noise * d * d, weights += foot.noise;
        }
        if (!(squares > kLeast * kLeast * weights)) return plain(i);
        const float scale = float(std::sqrt(weights / squares));
        Field<float> band = fine;
        for (std::size_t k = 0; k < band.size(); ++k)
            band[k] = scale * (band[k] - coarse[k]);
        return band;
    };
}

}  // namespace

NoiseSource::NoiseSource(const Options& options, const Terrain& terrain,
                         const Context& context)
    : options_(options), context_(context), spacing_(terrain.spacing) {
    if (!options.noise_from) return;
    if (options.noise == NoiseKind::kWavelet) {
        measure();
        return;
    }
    model_spacing_ = read_dem(*options.noise_from).spacing;
    if (options.noise != NoiseKind::kTexture) return;
    texture::Options land;
    land.exemplars.push_back({*options.noise_from, {}, {}});
    land.spacing = spacing_;
    land.scale = stretch();
    synthesised_ = texture::run(land, terrain, context).heights;
}

Noise NoiseSource::of(std::vector<Landform>& landforms, const Field<float>& land,
                      std::uint64_t seed) const {
    const int levels = int(landforms[0].noise.size());
    if (!strength_.empty())
        for (Landform& landform : landforms)
            landform.noise.assign(strength_.end() - levels, strength_.end());
    const Noise plain = wavelets(land, levels, seed);
    if (options_.noise == NoiseKind::kWavelet) return plain;
    return bands_of(options_.noise == NoiseKind::kTexture
                        ? synthesised_
                        : detailed(landforms, land, levels, seed),
                    spacing_, landforms, levels, plain);
}

// As strong as the model's bands; bands finer than its cells follow the fit.
void NoiseSource::measure() {
    const Terrain model = read_dem(*options_.noise_from);
    const int levels = options_.levels;
    const std::vector<double> own = noise_of_land(model.heights, levels).fitted;
    if (!(own.front() > 0.0 && own.back() > 0.0))
        throw bad_request("{}: the model is level and has no noise",
                          options_.noise_from->name());
    // A band of the model is a band of the terrain this many steps wider.
    const double wider = std::round(std::log2(model.spacing / spacing_));
    const double decay = std::log(own.back() / own.front()) / std::max(1, levels - 1);
    for (int i = 1; i <= levels; ++i)
        strength_.push_back(own.back() * std::exp(decay * (i - levels + wider)));
}

// Real land is taken sample for sample even where it is coarser than the terrain. Only
// its form counts; the silhouette says how strong it is.
double NoiseSource::stretch() const { return std::min(1.0, spacing_ / model_spacing_); }

// The difference that detail by example makes to the feature without noise.
Field<float> NoiseSource::detailed(const std::vector<Landform>& landforms,
                                   const Field<float>& land, int levels,
                                   std::uint64_t seed) const {
    std::vector<Landform> smooth = landforms;
    for (Landform& landform : smooth) std::ranges::fill(landform.noise, 0.0);
    Terrain bare;
    bare.spacing = spacing_;
    bare.heights = land;
    deform(bare.heights, spacing_, smooth, levels,
           [&](int) { return Field<float>(land.width(), land.height()); });
    detail::Options options;
    options.targets.push_back({*options_.noise_from, {}, stretch()});
    options.levels = std::min(levels, 5);
    Context context = context_;
    context.seed = seed;
    Field<float> added = detail::run(options, bare, context).heights;
    for (std::size_t i = 0; i < added.size(); ++i) added[i] -= bare.heights[i];
    return added;
}

}  // namespace cydonia::sketch
