#include "render/shadow/check.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/files.h"
#include "field/image.h"
#include "field/quantise.h"
#include "render/preview.h"
#include "render/shadow/caster.h"
#include "render/shadow/overlay.h"

namespace cydonia::render {

namespace {

using Mask = Field<std::uint8_t>;

double ratio(std::size_t part, std::size_t whole) {
    return whole == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(whole);
}

// Shadow black, light white, as targets are drawn.
void write_mask(const std::filesystem::path& path, Mask mask) {
    for (auto& m : mask) m = m ? 0 : 255;
    write_png(path, mask);
}

void check_request(const Terrain& terrain) {
    for (const ShadowImage& image : terrain.shadows)
        if (!image.target.same_shape(terrain.heights))
            throw bad_request("the target of '{}' has {}x{} cells, the terrain {}x{}",
                              image.name, image.target.width(), image.target.height(),
                              terrain.heights.width(), terrain.heights.height());
    // Rounding to 16 bits would hide them.
    if (!std::all_of(terrain.heights.begin(), terrain.heights.end(),
                     [](float h) { return std::isfinite(h); }))
        throw bad_request(
            "the terrain has heights that are not numbers: fill the voids first");
}

}  // namespace

std::vector<ShadowReport> check(const Terrain& terrain,
                                const std::filesystem::path& folder, Progress& progress) {
    check_request(terrain);
    if (terrain.shadows.empty()) return {};
    const Field<float> heights = heights_of(quantised(terrain.heights));
    const Caster caster(heights, terrain.spacing);
    const Field<float> ground = relief(heights, terrain.spacing);
    std::vector<ShadowReport> reports;
    for (const ShadowImage& image : terrain.shadows) {
        const Mask cast = caster.shadow(image.sun, kCheckRays);
        const Mask target = repeated(image.target, kCheckRays);
        const auto place = terrain.shadows.size() == 1 ? folder : folder / image.name;
        make_folder(place);
        write_mask(place / "cast.png", cast);
        write_mask(place / "target.png", target);
        write_png(place / "overlay.png", overlay(cast, image, ground));
        reports.push_back({image.name, image.sun, image.min_iou,
                           score(cast, image.target, image.window)});
        progress.report(ratio(reports.size(), terrain.shadows.size()));
    }
    return reports;
}

std::string advice(const ShadowReport& report) {
    if (report.passed()) return {};
    const auto [iou, precision, recall] = report.score;
    const double shown = std::floor(iou * 1000.0) / 1000.0;  // not up to what is wanted
    const double elevation = degrees(report.sun.elevation);
    std::string text = fmt::format(
        "The shadow of '{}' matches its target with IoU {:.3f} (precision {:.3f}, recall "
        "{:.3f}); {:.3f} is wanted.",
        report.name, shown, precision, recall, report.min_iou);
    // Shadows are h / tan(elevation) long: the elevation that makes them `times` as long.
    const auto elevation_for = [&](double times) {
        const double wanted = std::atan(std::tan(report.sun.elevation) / times);
        return std::clamp(degrees(wanted), 3.0, 80.0);
    };
    if (recall <= precision)
        text += fmt::format(
            " {:.0f}% of the target stays lit: the land there is too low for a sun at "
            "{:.1f} "
            "degrees. Lower the sun (try elevation = {:.0f}), draw the target's thin "
            "parts at "
            "least four cells wide, or raise terrain.samples.",
            100.0 * (1.0 - recall), elevation,
            elevation_for(1.0 / std::max(recall, 0.2)));
    if (precision <= recall)
        text += fmt::format(
            " {:.0f}% of the shadow falls outside the target: land that belongs to no "
            "caster "
            "is steeper than a sun at {:.1f} degrees allows. Raise the sun (try "
            "elevation = "
            "{:.0f}), or calm the base: fewer and lower features, smoother noise.",
            100.0 * (1.0 - precision), elevation,
            elevation_for(std::max(precision, 0.2)));
    return text + " overlay.png shows where: blue hit, yellow missed, pink spurious.";
}

}  // namespace cydonia::render
