#include "synth/detail/detail.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "field/parallel.h"
#include "field/sampled.h"
#include "synth/detail/fractal.h"
#include "synth/detail/quilting.h"
#include "synth/detail/roughness.h"

namespace cydonia::detail {
namespace {

// Adds `factor` times one field, weighted, to the other. Weights are of the coarse cells
// that values lie in, of which there are `scale` from west to east; empty: 1.
void add(const Field<float>& from, const Field<float>& weight, float factor, int scale,
         Field<float>& to) {
    parallel_for(to.height(), 16, [&](int y) {
        const float* in = from.row(y).data();
        float* out = to.row(y).data();
        if (weight.empty()) {
            for (int x = 0; x < to.width(); ++x) out[x] += factor * in[x];
            return;
        }
        const float* w = weight.row(std::min(y, weight.height() - 1)).data();
        for (int x = 0; x < to.width(); ++x)
            out[x] += factor * w[std::min(x / scale, weight.width() - 1)] * in[x];
    });
}
void add(const Details& from, const Field<float>& weight, float factor, Details& to) {
    add(from.columns, weight, factor, 2, to.columns);
    add(from.rows, weight, factor, 1, to.rows);
}

Field<float> product(Field<float> a, const Field<float>& b) {
    if (b.empty()) return a;
    for (std::size_t i = 0; i < a.size(); ++i) a[i] *= b[i];
    return a;
}

// The examples that a layer may take from; they are in the order of their targets.
std::span<const Example> of_target(std::span<const Example> all, int target) {
    if (target < 0) return all;
    const auto range = std::ranges::equal_range(all, target, {}, &Example::target);
    return {range.begin(), range.end()};
}

// One layer, from level to level.
class Quilt {
  public:
    Quilt(const Layer& layer, std::span<const Example> examples, const Options& options,
          double side, std::uint64_t seed)
        : layer_(layer),
          examples_(of_target(examples, layer.target)),
          options_(options),
          side_(side),
          seed_(seed) {
        if (!options.adapt) return;
        for (const Example& example : examples_)
            roughness_.push_back(
                roughness_of(example.levels.back().coarse, options.filter));
    }

    bool has_details(int level) const {
        return std::ranges::any_of(
            examples_, [&](const Example& e) { return e.level(level) != nullptr; });
    }

    // Of a land so large whose cells are 2^`halvings` samples; empty: 1 everywhere.
    Field<float> share(int halvings, const Field<float>& land) const {
        if (layer_.share.empty()) return {};
        Field<float> result = sampled(layer_.share, {0.0, 0.0, std::ldexp(1.0, halvings)},
                                      land.width(), land.height());
        for (float& s : result) s = std::clamp(s, 0.0f, 1.0f);
        return result;
    }

    // Adds its details of a level to the land's. `rough`: of the coarsest land, if asked
    // for.
    void add_to(Details& details, const Field<float>& coarse, const Field<float>& share,
                int level, const Field<float>& rough) {
        match(coarse, share, level);
        const bool noise = options_.kind == Kind::kMultifractal;
        Details found = quilted(blocks_, matches_, examples_, level, options_.filter,
                                noise ? Fading::kMean : Fading::kVariance);
        if (noise) make_noise(found, seed_, level);
        Field<float> weight = share;
        if (options_.adapt)
            weight = product(gain_of(blocks_, matches_, rough, roughness_,
                                     options_.levels - 1 - level),
                             share);
        add(found, weight, float(options_.strength), details);
    }

    void add_noise_to(Field<float>& land, int level) const {
        const double scale =
            fractal_scale(examples_, options_.filter, level, options_.levels);
        add_noise(land, options_.strength * scale, share(level, land), seed_, level);
    }

  private:
    void match(const Field<float>& coarse, const Field<float>& share, int level) {
        if (layer_.shift) {
            const auto [dx, dy] = *layer_.shift;
            blocks_ = {coarse.width(), coarse.height(),
                       std::max(coarse.width(), coarse.height()), 0};
            matches_ = {{0, dx >> (level + 1), dy >> (level + 1)}};
            return;
        }
        const Blocks before = std::exchange(
            blocks_, blocks_of(coarse.width(), coarse.height(),
                               int(std::lround(std::ldexp(side_, -level - 1)))));
        const Searching searching{options_.search, options_.candidates, level, seed_};
        matches_ = matched(coarse, blocks_, examples_, searching, before, matches_,
                           [&](int block) { return touches(block, share); });
    }

    bool touches(int block, const Field<float>& share) const {
        if (share.empty()) return true;
        const int x0 = block % blocks_.across() * blocks_.step,
                  y0 = block / blocks_.across() * blocks_.step;
        for (int y = y0; y < std::min(y0 + blocks_.side(), blocks_.height); ++y)
            for (int x = x0; x < std::min(x0 + blocks_.side(), blocks_.width); ++x)
                if (share(x, y) > 0.0f) return true;
        return false;
    }

    const Layer& layer_;
    std::span<const Example> examples_;
    const Options& options_;
    double side_;
    std::uint64_t seed_;
    Blocks blocks_;
    std::vector<Match> matches_;           // of the level before
    std::vector<Field<float>> roughness_;  // of the examples' coarsest land
};

}  // namespace

Field<float> refined(Field<float> coarse, std::span<const Level> own,
                     std::span<const Example> examples, std::span<const Layer> layers,
                     const Options& options, double side, std::uint64_t seed,
                     Progress& progress) {
    std::vector<Quilt> quilts;
    for (const Layer& layer : layers)
        quilts.emplace_back(layer, examples, options, side, seed);
    Field<float> rough;
    if (options.adapt) rough = roughness_of(coarse, options.filter);
    for (int level = options.levels - 1; level >= 0; --level) {
        Details details = no_details(options.filter, coarse.width(), coarse.height());
        const auto add_own = [&](const Field<float>& weight, float factor) {
            if (!own.empty())
                add(own[std::size_t(level)].details, weight, factor, details);
        };
        add_own({}, 1.0f);
        for (Quilt& quilt : quilts) {
            if (!quilt.has_details(level)) continue;
            const Field<float> share = quilt.share(level + 1, coarse);
            add_own(share, -1.0f);
            if (options.kind != Kind::kFractal)
                quilt.add_to(details, coarse, share, level, rough);
        }
        coarse = subdivided(coarse, details, options.filter);
        if (options.kind == Kind::kFractal)
            for (const Quilt& quilt : quilts) quilt.add_noise_to(coarse, level);
        progress.report(double(options.levels - level) / options.levels);
    }
    return coarse;
}

Terrain run(const Options& options, const Terrain& terrain, const Context& context) {
    Progress& progress = *context.progress;
    progress.step("detail: reading the targets");
    std::vector<Example> examples = examples_of(options, terrain.spacing, progress);
    const Field<float>& heights = terrain.heights;
    const int width = heights.width(), height = heights.height();
    const std::vector<Layer> layers = layers_of(options, examples, width, height);
    if (options.kind == Kind::kMultifractal)
        for (Example& example : examples) take_scale(example);

    progress.step("detail: quilting");
    const std::vector<Level> own =
        decomposed(padded(heights, divisible(options.filter, width, options.levels),
                          divisible(options.filter, height, options.levels)),
                   options.filter, options.levels);
    const Field<float> made =
        refined(own.back().coarse, own, examples, layers, options,
                block_side(options, width, height), context.seed, progress);

    Terrain result = terrain;
    parallel_for(height, 16, [&](int y) {
        for (int x = 0; x < width; ++x) {
            // Where edges are soft, details reach a little further than their share.
            float touched = 0.0f;
            for (const Layer& layer : layers)
                touched += layer.share.empty() ? 1.0f : 8.0f * layer.share(x, y);
            const float share = std::min(1.0f, touched);
            if (share > 0.0f)
                result.heights(x, y) += share * (made(x, y) - heights(x, y));
        }
    });
    double squares = 0.0;
    for (std::size_t i = 0; i < heights.size(); ++i)
        squares += std::pow(double(result.heights[i]) - heights[i], 2.0);
    result.figures["detail: change, RMS, m"] =
        std::sqrt(squares / double(heights.size()));
    return result;
}

}  // namespace cydonia::detail
