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

// Adds `factor` times one field, weighted, to the other. A weight belongs to the coarse
// cell in which values lie, `scale` of them from west to east; without weights they are
// 1.
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

// The examples that a layer may use. Examples are in the order of their targets.
std::span<const Example> of_target(std::span<const Example> all, int target) {
    if (target < 0) return all;
    const auto range = std::ranges::equal_range(all, target, {}, &Example::target);
    return {range.begin(), range.end()};
}

// The side of a block in cells of a level's coarse land.
int cells_of(double side, int level) {
    return int(std::lround(std::ldexp(side, -level - 1)));
}

// One layer while it goes from level to level.
class Quilt {
  public:
    Quilt(const Layer& layer, std::span<const Example> examples, const Options& options,
          const Window& window, double side, std::uint64_t seed)
        : layer_(layer),
          examples_(of_target(examples, layer.target)),
          options_(options),
          finest_(window),
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

    // The layer's share on a land so large, whose cells are 2^`halvings` samples wide;
    // empty: 1 everywhere.
    Field<float> share(int halvings, const Field<float>& land) const {
        if (layer_.share.empty()) return {};
        Field<float> result = sampled(layer_.share, {0.0, 0.0, std::ldexp(1.0, halvings)},
                                      land.width(), land.height());
        for (float& s : result) s = std::clamp(s, 0.0f, 1.0f);
        return result;
    }

    // Adds the layer's details of a level to the land's. `rough` is the roughness of the
    // coarsest land, if details adapt to it.
    void add_to(Details& details, const Field<float>& coarse, const Field<float>& share,
                int level, const Field<float>& rough) {
        match(coarse, share, level);
        const bool noise = options_.kind == Kind::kMultifractal;
        Details found = quilted(coarse.width(), coarse.height(), window(level, coarse),
                                blocks_, matches_, examples_, level, options_.filter,
                                noise ? Fading::kMean : Fading::kVariance);
        if (noise) make_noise(found, window(level, coarse), seed_, level);
        Field<float> weight = share;
        if (options_.adapt)
            weight = product(
                gain_of(coarse.width(), coarse.height(), window(level, coarse), blocks_,
                        matches_, rough, roughness_, options_.levels - 1 - level),
                share);
        add(found, weight, float(options_.strength), details);
    }

    void add_noise_to(Field<float>& land, int level) const {
        const double scale =
            fractal_scale(examples_, options_.filter, level, options_.levels);
        add_noise(land, window(level - 1, land), options_.strength * scale,
                  share(level, land), seed_, level);
    }

  private:
    // Where a level's coarse land lies in that of the whole land.
    Window window(int level, const Field<float>& coarse) const {
        if (finest_.width == 0) return {0, 0, coarse.width(), coarse.height()};
        Window window{finest_.x >> (level + 1), finest_.y >> (level + 1), finest_.width,
                      finest_.height};
        for (int i = 0; i <= level; ++i) {
            window.width = coarser(options_.filter, window.width);
            window.height = coarser(options_.filter, window.height);
        }
        return window;
    }

    void match(const Field<float>& coarse, const Field<float>& share, int level) {
        const Window here = window(level, coarse);
        if (layer_.shift) {
            const auto [dx, dy] = *layer_.shift;
            blocks_ = {here.width, here.height, std::max(here.width, here.height), 0};
            matches_ = {{0, dx >> (level + 1), dy >> (level + 1)}};
            return;
        }
        const Blocks before = std::exchange(
            blocks_, blocks_of(here.width, here.height, cells_of(side_, level)));
        const Searching searching{options_.search, options_.candidates, level, seed_};
        matches_ = matched(coarse, here, blocks_, examples_, searching, before, matches_,
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
    Window finest_;
    double side_;
    std::uint64_t seed_;
    Blocks blocks_;
    std::vector<Match> matches_;           // on the level before
    std::vector<Field<float>> roughness_;  // of the coarsest land of each example
};

std::vector<Example> prepared(const Options& options, double spacing,
                              Progress& progress) {
    progress.step("detail: reading the targets");
    std::vector<Example> examples = examples_of(options, spacing, progress);
    if (options.kind == Kind::kMultifractal)
        for (Example& example : examples) take_scale(example);
    return examples;
}

// A part of a land of `extent`, from column x and row y on, with new details. Where the
// part ends inside the land it is mirrored, so that a border as wide as reach() is wrong.
Field<float> made(const Field<float>& part, int x, int y, const Extent& extent,
                  std::span<const Example> examples, std::span<const Layer> layers,
                  const Options& options, const Context& context) {
    context.progress->step("detail: quilting");
    const auto whole = [&](int samples) {
        return divisible(options.filter, samples, options.levels);
    };
    const auto padded_to = [&](int samples, int from, int all) {
        return from + samples == all ? whole(all) - from : whole(samples);
    };
    const std::vector<Level> own =
        decomposed(padded(part, padded_to(part.width(), x, extent.columns),
                          padded_to(part.height(), y, extent.rows)),
                   options.filter, options.levels);
    return refined(own.back().coarse, own, examples, layers, options,
                   {x, y, whole(extent.columns), whole(extent.rows)},
                   block_side(options, extent.columns, extent.rows), context.seed,
                   *context.progress);
}

}  // namespace

Field<float> refined(Field<float> coarse, std::span<const Level> own,
                     std::span<const Example> examples, std::span<const Layer> layers,
                     const Options& options, const Window& window, double side,
                     std::uint64_t seed, Progress& progress) {
    std::vector<Quilt> quilts;
    for (const Layer& layer : layers)
        quilts.emplace_back(layer, examples, options, window, side, seed);
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
    const Field<float>& heights = terrain.heights;
    const Extent extent{heights.width(), heights.height(), terrain.spacing};
    const auto examples = prepared(options, terrain.spacing, *context.progress);
    const auto layers = layers_of(options, examples, extent.columns, extent.rows);
    const Field<float> detailed =
        made(heights, 0, 0, extent, examples, layers, options, context);
    // At soft edges details reach slightly farther than the layer's share.
    const auto share = [&](int x, int y) {
        float sum = 0.0f;
        for (const Layer& layer : layers)
            sum += layer.share.empty() ? 1.0f : 8.0f * layer.share(x, y);
        return std::min(1.0f, sum);
    };
    Terrain result = terrain;
    double squares = 0.0;
    for (int y = 0; y < extent.rows; ++y)
        for (int x = 0; x < extent.columns; ++x) {
            const float s = share(x, y), change = detailed(x, y) - heights(x, y);
            if (s > 0.0f)
                result.heights(x, y) =
                    s < 1.0f ? heights(x, y) + s * change : detailed(x, y);
            squares += double(s * change) * (s * change);
        }
    result.figures["detail: change, RMS, m"] =
        std::sqrt(squares / double(heights.size()));
    return result;
}

int reach(const Options& options, const Extent& extent) {
    // The ends of filters and the radius of the land's roughness.
    int samples = 24 << options.levels;
    const double side = block_side(options, extent.columns, extent.rows);
    for (int level = 0; level < options.levels; ++level) {
        const Blocks blocks =
            blocks_of(extent.columns, extent.rows, cells_of(side, level));
        samples += (blocks.side() + 4) << (level + 1);
    }
    return samples;
}

Field<float> tile(const Options& options, const Extent& extent, const Heights& before,
                  const Context& context, int x, int y, int width, int height) {
    const int around = reach(options, extent);
    const auto begin = [&](int at) {
        // A multiple for all levels and the one above them, which measures the land's
        // roughness.
        const int grain = options.levels + 1;
        return std::max(0, at - around) >> grain << grain;
    };
    const int left = begin(x), top = begin(y);
    const Field<float> part =
        before(left, top, std::min(extent.columns, x + width + around) - left,
               std::min(extent.rows, y + height + around) - top);
    const Field<float> detailed = made(
        part, left, top, extent, prepared(options, extent.spacing, *context.progress),
        std::vector{Layer{}}, options, context);
    Field<float> result(width, height);
    for (int row = 0; row < height; ++row)
        std::copy_n(detailed.row(y - top + row).begin() + (x - left), width,
                    result.row(row).begin());
    return result;
}

}  // namespace cydonia::detail
