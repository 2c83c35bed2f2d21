#include "synth/pareidolia/constrained/constrained.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "field/cells_inside.h"
#include "field/error.h"
#include "field/image.h"
#include "field/noise.h"
#include "field/random.h"
#include "synth/pareidolia/constrained/bend.h"
#include "synth/pareidolia/constrained/calm.h"
#include "synth/pareidolia/constrained/contradictions.h"
#include "synth/pareidolia/constrained/rounds.h"
#include "synth/pareidolia/constrained/window.h"

namespace cydonia::pareidolia {
namespace {

// The coarsest grid has at most so many cells along a side.
constexpr int kCoarsest = 64;
constexpr int kCoarseIterations = 100, kHalfIterations = 50, kFineIterations = 24;
// Margins at faithful = 1, as shares of the light's own fall.
constexpr double kLight = 0.1, kCrisp = 0.25;
constexpr double kAnyDepth = 1e6;
// The width, in cells, of the ground around a window that must be lit too, so that
// natural shadows end outside it.
constexpr float kRim = 2.0f;
// The cost of curvature relative to that of slope at natural = 1.
constexpr double kBend = 0.3;
// The cost of a change in height alone on 512 cells a side, which holds ground that
// nothing else holds.
constexpr double kKeep = 1e-6;
// Reductions of the base's slopes below this are not reported.
constexpr double kSaidSmoothing = 0.25;

cv::Mat mat(Field<float>& field) {
    return {field.height(), field.width(), CV_32F, field.data()};
}

Field<float> shrunk(Field<float> field, int width, int height) {
    Field<float> result(width, height);
    cv::Mat out = mat(result);
    cv::resize(mat(field), out, out.size(), 0, 0, cv::INTER_AREA);
    return result;
}

// A change of coarser land on finer cells, without stairs.
Field<float> grown(Field<float> change, int width, int height) {
    Field<float> result(width, height);
    cv::Mat out = mat(result);
    cv::resize(mat(change), out, out.size(), 0, 0, cv::INTER_CUBIC);
    cv::GaussianBlur(out, out, cv::Size(), 2.0, 0, cv::BORDER_REFLECT);
    return result;
}

Field<float> sum(Field<float> a, const Field<float>& b, float sign) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += sign * b[i];
    return a;
}

// Noise from 0 to 1 with wavelengths of at most a twenty-fourth of the land.
Field<float> wandering(int width, int height, std::uint64_t seed) {
    Field<float> noise = noise_field({.h = 0.8, .octaves = 3, .grid = 24.0}, width,
                                     height, 1.0, hash_of({seed, key("wandering")}));
    for (float& n : noise) n = std::clamp(0.5f + n, 0.0f, 1.0f);
    return noise;
}

Demand shown(const ShadowImage& image, const ConstrainedOptions& options,
             const Field<float>& noise, bool alone) {
    const Field<std::uint8_t>& target = image.target;
    Demand demand{image.sun, Field<Part>(target.width(), target.height(), Part::kFree),
                  cells_inside(target, true),
                  Field<float>(target.width(), target.height()),
                  Field<float>(target.width(), target.height(),
                               static_cast<float>(kCrisp * options.faithful)),
                  // Several images need the full depth.
                  alone && options.hidden > 0.0 ? 1.0 / options.hidden : kAnyDepth};
    const Field<float> beyond = cells_inside(image.window, false);
    for (std::size_t i = 0; i < target.size(); ++i) {
        // Lit ground that rises evenly everywhere would look unnaturally smooth.
        demand.light[i] =
            static_cast<float>(kLight * options.faithful * (0.5 + noise[i]));
        if (!image.relaxed.empty() && image.relaxed[i]) continue;
        if (target[i])
            demand.parts[i] = Part::kShadow;
        else if (beyond[i] <= kRim)
            demand.parts[i] = Part::kLit;
    }
    return demand;
}

// The heights of the base where the land must not change, NaN elsewhere. A coarse cell
// that contains a NaN is not kept.
Field<float> kept_heights(const std::optional<Source>& keep, const Field<float>& base) {
    if (!keep) return {};
    const Field<float> grey = resized(read_grey(*keep), base.width(), base.height());
    Field<float> kept = base;
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (!(grey[i] > 0.5f)) kept[i] = std::numeric_limits<float>::quiet_NaN();
    return kept;
}

void note_relaxed(const Rounds& rounds, std::vector<ShadowImage>& images) {
    for (std::size_t i = 0; i < images.size(); ++i) {
        const int width = images[i].target.width(), height = images[i].target.height();
        Field<std::uint8_t>& relaxed = images[i].relaxed;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                if (!rounds.gave_way(i, x, y)) continue;
                if (relaxed.empty()) relaxed = Field<std::uint8_t>(width, height);
                relaxed(x, y) = 1;
            }
    }
}

void say_contradictions(const Contradictions& found,
                        const std::vector<ShadowImage>& images, Progress& progress) {
    std::ptrdiff_t cells = 0;
    for (const ShadowImage& image : images)
        cells += std::count(image.relaxed.begin(), image.relaxed.end(), 1);
    if (cells == 0) return;
    if (found.quadruples == 0) {
        progress.note(
            fmt::format("{} cells are relaxed in favour of another sun's image", cells));
        return;
    }
    progress.warn(
        fmt::format("the images contradict one another under their suns: {} cells are "
                    "relaxed; in any land at least {} cells are wrong, and the mean IoU "
                    "cannot be above {:.3f}: move, turn or scale an image so that they "
                    "share fewer lines of light, or "
                    "bring the suns together",
                    cells, found.least_wrong, found.bound));
}

}  // namespace

Field<float> constrained(const Options& options, const Terrain& base,
                         std::vector<ShadowImage>& images, const Context& context) {
    const int width = base.heights.width(), height = base.heights.height();
    const ConstrainedOptions& wishes = options.constrained;
    const Field<float> noise = wandering(width, height, context.seed);
    for (ShadowImage& image : images) image.window = window_of(image.target, noise);
    const Contradictions contradictions = settle(images);

    std::vector<Demand> demands;
    for (const ShadowImage& image : images)
        demands.push_back(shown(image, wishes, noise, images.size() == 1));
    const Field<float> kept = kept_heights(wishes.keep, base.heights);

    double smoothed = 0.0;
    std::vector<Field<float>> lands{calmed(base, images, wishes.hidden, &smoothed)};
    if (smoothed > kSaidSmoothing)
        context.progress->note(fmt::format(
            "the base is too rough for its sun to light it: around the image its slopes "
            "were lessened by {:.0f}%",
            100.0 * smoothed));
    while (std::max(lands.back().width(), lands.back().height()) > kCoarsest &&
           std::min(lands.back().width(), lands.back().height()) > 8)
        lands.push_back(shrunk(lands.back(), (lands.back().width() + 1) / 2,
                               (lands.back().height() + 1) / 2));

    // Every grid starts from the bend of the coarser one and changes it as little as
    // possible.
    Field<float> bent = lands.back();
    const int levels = static_cast<int>(lands.size());
    for (int level = levels - 1; level >= 0; --level) {
        const Field<float>& land = lands[static_cast<std::size_t>(level)];
        if (level < levels - 1)
            bent = sum(grown(sum(bent, lands[static_cast<std::size_t>(level) + 1], -1.0f),
                             land.width(), land.height()),
                       land, 1.0f);
        const double cells = static_cast<double>(width) / land.width();
        const double size = 512.0 / land.width();
        Bend bend(
            bent, base.spacing * cells, cells,
            kept.empty() ? Field<float>() : shrunk(kept, land.width(), land.height()),
            {.stiffness = {1.0, kBend * wishes.natural, kKeep * size * size},
             .stops = level == 0 ? Stops::kEveryEdge : Stops::kColumns});
        bend.demand(demands);
        bend.run(level == 0   ? kFineIterations
                 : level == 1 ? kHalfIterations
                              : kCoarseIterations);
        context.progress->report(0.7 * (levels - level) / levels);
        bent = bend.heights();
        if (level > 0) continue;
        Rounds rounds(base.spacing, demands, context);
        bent = rounds.best_of(bend);
        note_relaxed(rounds, images);
    }
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (std::isfinite(kept[i])) bent[i] = kept[i];
    say_contradictions(contradictions, images, *context.progress);
    context.progress->report(1.0);
    return bent;
}

}  // namespace cydonia::pareidolia
