#include "synth/texture/maker.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/sample.h"
#include "field/sampled.h"

namespace cydonia::texture {

using namespace geometry;

namespace {

// Spacings whose ratio differs from 1 by less are treated as equal, so that land is not
// resampled.
constexpr double kSameSpacing = 0.01;

// The coarsest level whose cells are still as fine as the samples. So the same extent
// with fewer samples is the same land, stopped at a coarser level.
int finest_level(const Database& database, double spacing) {
    const int most = static_cast<int>(database.levels.size()) - 1;
    const double steps = std::log2(spacing / database.spacing * (1.0 + kSameSpacing));
    return std::clamp(static_cast<int>(std::floor(steps)), 0, most);
}

Controls controls_of(const Options& options, std::uint64_t seed, int finest) {
    return {.seed = seed,
            .jitter = options.jitter,
            .kappa = options.kappa,
            .stiffness = options.stiffness,
            .pull = options.pull,
            .orientations = options.orientations,
            .finest = finest};
}

// The land as it would be without constraints, for heights that are relative to it. It is
// made two levels coarser, where its shape is already settled.
class Natural {
  public:
    Natural(const Database& database, Controls controls, const Ground& ground,
            const Guidance& guidance, Progress& progress) {
        controls.finest = std::min(controls.finest + kFinestGuided,
                                   static_cast<int>(database.levels.size()) - 1);
        cell_ = ground.spacing * (1 << controls.finest);
        depth_ = ground.depth;
        const Window window = Window{controls.finest, 0, 0,
                                     static_cast<int>(std::ceil(ground.width / cell_)),
                                     static_cast<int>(std::ceil(ground.depth / cell_))}
                                  .grown(kReadOut);
        heights_ = heights_of(database, synthesised(database, controls, guidance, window,
                                                    nullptr, progress));
    }
    double at(double x, double y) const {
        return bilinear(heights_, x / cell_ - 0.5, (depth_ - y) / cell_ - 0.5);
    }

  private:
    double cell_, depth_;
    Field<float> heights_;
};

bool any_relative(const Options& options) {
    return std::ranges::any_of(options.points, &Point::relative) ||
           std::ranges::any_of(options.curves, &Curve::relative);
}

}  // namespace

Maker::Maker(const Options& options, const Extent& extent, const Context& context)
    : extent_(extent),
      progress_(*context.progress),
      database_(database_of(options, context.cache, progress_)) {
    const int finest = finest_level(*database_, extent.spacing);
    controls_ = controls_of(options, context.seed, finest);
    ground_ = {extent.width(), extent.depth(), database_->spacing};
    ratio_ = extent.spacing / (database_->spacing * (1 << finest));
    if (std::abs(ratio_ - 1.0) < kSameSpacing) {
        ratio_ = 1.0;
        ground_.spacing = extent.spacing / (1 << finest);
    }
    if (ratio_ < 1.0)
        progress_.warn(fmt::format(
            "texture: the exemplars' cells are {:.4g} m and the terrain's {:.4g} m: the "
            "land has no detail finer than its exemplars; set samples to {} or scale to "
            "{:.3g}",
            database_->spacing, extent.spacing,
            std::lround(std::max(extent.columns, extent.rows) * ratio_), ratio_));

    types_ = std::make_unique<TypeMap>(options, ground_,
                                       static_cast<int>(database_->levels.size()));
    if (!types_->empty())
        guidance_.types = [this](const Window& window) { return types_->sets(window); };

    std::unique_ptr<Natural> natural;
    if (any_relative(options)) {
        progress_.step("texture: the land without constraints");
        natural = std::make_unique<Natural>(*database_, controls_, ground_, guidance_,
                                            progress_);
    }
    geometry_ = std::make_unique<Geometry>(
        options, ground_, [&](double x, double y) { return natural->at(x, y); },
        progress_);
    if (!geometry_->empty())
        guidance_.pulls = [this](const Window& window) {
            return geometry_->pulls(window);
        };
    const Guidance without_pastes = guidance_;
    pasting_ = std::make_unique<Pasting>(
        options, *database_, ground_, finest, [&](const Window& window) {
            Recording passes;
            synthesised(*database_, controls_, without_pastes, window, &passes,
                        progress_);
            return passes;
        });
    if (!pasting_->empty())
        guidance_.pinned = [this](const Window& window, int pass) {
            PinnedRegion pinned;
            pasting_->lay_down(window, pass, pinned);
            return pinned;
        };
}

Window Maker::window_of(int x, int y, int width, int height) const {
    Window window{controls_.finest, x, y, width, height};
    if (ratio_ != 1.0) {
        // Cubic weights reach two cells, or two samples where those are wider.
        const int halo = 2 * static_cast<int>(std::ceil(std::max(1.0, ratio_))) + 1;
        const auto from = [&](int at) {
            return static_cast<int>(std::floor(at * ratio_)) - halo;
        };
        const auto to = [&](int at) {
            return static_cast<int>(std::ceil(at * ratio_)) + halo;
        };
        window = {controls_.finest, from(x), from(y), to(x + width) - from(x),
                  to(y + height) - from(y)};
    }
    return window.grown(kReadOut);
}

Field<float> Maker::heights(const Synthesis& synthesis, int x, int y, int width,
                            int height) const {
    Field<float> heights = heights_of(*database_, synthesis);
    if (ratio_ == 1.0) return heights;
    const Window cells = synthesis.window.grown(-kReadOut);
    return sampled(heights,
                   {.cell = ratio_,
                    .column = x,
                    .row = y,
                    .from_column = cells.x,
                    .from_row = cells.y},
                   width, height);
}

}  // namespace cydonia::texture
