#include "render/shadow/figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/error.h"
#include "field/parallel.h"
#include "field/quantise.h"
#include "render/shadow/lineup.h"
#include "render/shadow/outline.h"
#include "render/shadow/soft.h"

namespace cydonia::render {

namespace {

using Mask = Field<std::uint8_t>;

constexpr double kTurns[] = {10, -10, 30, -30, 45, -45, 90, -90, 180};  // degrees
constexpr double kRaised = 45.0;   // elevation of the raised sun, degrees, or
constexpr double kAtLeast = 20.0;  // this much above the image's own sun

std::vector<OtherSun> other_suns(const Sun& own) {
    std::vector<OtherSun> result;
    for (const double turn : kTurns)
        result.push_back(
            {{own.azimuth + radians(turn), own.elevation}, radians(turn), {}, {}});
    const double raised = std::max(radians(kRaised), own.elevation + radians(kAtLeast));
    result.push_back({{own.azimuth, std::min(raised, radians(89.0))}, 0.0, {}, {}});
    return result;
}

// What traces of an image are measured with.
struct Sought {
    const Mask& target;
    Mask near;  // its outline
    Lineup lineup;
};

Trace trace(const CheckedLand& land, const Sun& sun, const Sought& sought) {
    const Mask cast = land.caster.shadow(sun, 1);
    return {correlation(cast, sought.target),
            outline_shading(land.heights, land.spacing, sun, sought.near),
            sought.lineup.standing_out(cast)};
}

template <class Wanted, class Value>
double mean_over(const ShadowFigures& figures, const Wanted& wanted, const Value& value) {
    double sum = 0.0;
    int count = 0;
    for (const OtherSun& other : figures.other_suns)
        if (wanted(other)) {
            sum += value(other);
            ++count;
        }
    return count ? sum / count : 0.0;
}

auto turned_by(double wanted_degrees) {
    return [wanted_degrees](const OtherSun& other) {
        return std::abs(std::abs(degrees(other.turned)) - wanted_degrees) < 0.5;
    };
}

}  // namespace

CheckedLand::CheckedLand(const Field<float>& raw, double cell)
    : heights(heights_of(quantised(raw))), spacing(cell), caster(heights, cell) {}

void check_shapes(const Field<float>& heights, const ShadowImage& image) {
    const auto fits = [&](const Mask& mask) {
        return mask.empty() || mask.same_shape(heights);
    };
    if (!image.target.same_shape(heights))
        throw bad_request("the target of '{}' has {}x{} cells, the terrain {}x{}",
                          image.name, image.target.width(), image.target.height(),
                          heights.width(), heights.height());
    if (!fits(image.window) || !fits(image.relaxed))
        throw bad_request("the masks of '{}' differ in shape from its target",
                          image.name);
}

Relaxed relaxed(const ShadowImage& image) {
    if (image.relaxed.empty()) return {};
    std::size_t cells = 0, dark = 0, missed = 0, spurious = 0;
    for (std::size_t i = 0; i < image.target.size(); ++i) {
        if (!image.window.empty() && !image.window[i]) continue;
        const bool wanted = image.target[i] != 0, gave = image.relaxed[i] != 0;
        ++cells;
        dark += wanted;
        missed += gave && wanted;
        spurious += gave && !wanted;
    }
    if (cells == 0 || dark + spurious == 0) return {};
    return {static_cast<double>(missed + spurious) / static_cast<double>(cells),
            static_cast<double>(dark - missed) / static_cast<double>(dark + spurious)};
}

ShadowFigures shadow_figures(const CheckedLand& land, const CheckedLand* base,
                             const ShadowImage& image) {
    check_shapes(land.heights, image);
    if (base && !base->heights.same_shape(land.heights))
        throw bad_request("the base has {}x{} heights, the land {}x{}",
                          base->heights.width(), base->heights.height(),
                          land.heights.width(), land.heights.height());
    const Mask& target = image.target;
    const Mask& window = image.window;
    ShadowFigures figures;

    const Mask fine = land.caster.shadow(image.sun, 2);
    figures.fine = score(fine, target, window);
    figures.iou_frame = score(fine, target).iou;
    figures.outline = outline_score(fine, target, window);
    figures.thin_recall = thin_recall(fine, target, window);
    figures.iou_4x4 = score(land.caster.shadow(image.sun, 4), target, window).iou;
    figures.iou_soft = score(soft_shadow(land.caster, image.sun, 2), target, window).iou;
    figures.relaxed = relaxed(image);

    const Mask cast = land.caster.shadow(image.sun, 1);
    figures.iou_1x1 = score(cast, target, window).iou;
    const Sought sought{target, near_outline(target), Lineup(target)};
    figures.standing_out = sought.lineup.standing_out(cast);
    figures.other_suns = other_suns(image.sun);
    parallel_for(static_cast<int>(figures.other_suns.size()), [&](int i) {
        OtherSun& other = figures.other_suns[static_cast<std::size_t>(i)];
        other.land = trace(land, other.sun, sought);
        if (base) other.base = trace(*base, other.sun, sought);
    });

    figures.land = land_figures(land.heights, land.spacing);
    if (base) figures.base = land_figures(base->heights, base->spacing);
    return figures;
}

double hiddenness(const ShadowFigures& figures, double turned_degrees) {
    return mean_over(figures, turned_by(turned_degrees),
                     [](const OtherSun& other) { return std::abs(other.correlation()); });
}

double outline_ratio(const ShadowFigures& figures) {
    return mean_over(figures, turned_by(90.0),
                     [](const OtherSun& other) { return other.land.outline; });
}

double outline_ratio_of_base(const ShadowFigures& figures) {
    return mean_over(figures, turned_by(90.0), [](const OtherSun& other) {
        return other.base ? other.base->outline : 1.0;
    });
}

double worst_standing_out(const ShadowFigures& figures) {
    double worst = 0.0;
    for (const OtherSun& other : figures.other_suns)
        if (!turned_by(10.0)(other))
            worst = std::max(worst, std::abs(other.land.standing_out));
    return worst;
}

}  // namespace cydonia::render
