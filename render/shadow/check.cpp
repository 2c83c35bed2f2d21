#include "render/shadow/check.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/files.h"
#include "field/image.h"
#include "render/maps/hillshade.h"
#include "render/shadow/overlay.h"
#include "render/shadow/sun_clock.h"

namespace fs = std::filesystem;

namespace cydonia::render {

namespace {

using Mask = Field<std::uint8_t>;

// A mask as a picture: shadow black and light white, as targets are drawn.
void write_mask(const fs::path& path, Mask mask) {
    for (auto& m : mask) m = m ? 0 : 255;
    write_png(path, mask);
}

// A window as a picture: white where shadows count.
void write_window(const fs::path& path, Mask window) {
    for (auto& w : window) w = w ? 255 : 0;
    write_png(path, window);
}

void check_request(const Terrain& terrain) {
    for (const ShadowImage& image : terrain.shadows) check_shapes(terrain.heights, image);
    // Checked before rounding to 16 bits hides them.
    if (!std::all_of(terrain.heights.begin(), terrain.heights.end(),
                     [](float h) { return std::isfinite(h); }))
        throw bad_request(
            "the terrain has heights that are not numbers: fill the voids first");
}

fs::path place_of(const Terrain& terrain, const ShadowImage& image,
                  const fs::path& folder) {
    return terrain.shadows.size() == 1 ? folder : folder / image.name;
}

// The other image that wants most of the cells that were left by `image`.
std::string rival_of(const ShadowImage& image, const std::vector<ShadowImage>& all) {
    std::string rival;
    std::size_t most = 0;
    for (const ShadowImage& other : all) {
        if (&other == &image) continue;
        const Mask& asked = other.window.empty() ? other.target : other.window;
        std::size_t shared = 0;
        for (std::size_t i = 0; i < image.relaxed.size(); ++i)
            shared += image.relaxed[i] && asked[i];
        if (shared > most) {
            most = shared;
            rival = other.name;
        }
    }
    return rival;
}

// Rounded down, so that 0.8498 does not read as 0.85.
double shown(double iou) { return std::floor(iou * 1000.0) / 1000.0; }

// The elevation that makes shadows, which are h / tan(elevation) long, `times` as long.
double elevation_for(const Sun& sun, double times) {
    const double wanted = std::atan(std::tan(sun.elevation) / times);
    return std::clamp(degrees(wanted), 3.0, 80.0);
}

// Advice for images that contradict one another: no land shows them all.
std::string about_rivals(const ShadowReport& report) {
    const std::string other =
        report.rival.empty() ? "the other images" : fmt::format("'{}'", report.rival);
    return fmt::format(
        " {:.1f}% of its window gave way to {}, which asks for the opposite there: no "
        "land shows both. Move the two apart (position) or scale either down until "
        "their windows share no ground; or relight them from one azimuth, so that what "
        "the higher sun shades lies within what the lower one does.",
        100.0 * report.relaxed, other);
}

std::string about_light(const ShadowReport& report) {
    return fmt::format(
        " {:.0f}% of the target stays lit: the land there is too low for a sun at {:.1f} "
        "degrees. Lower the sun (try elevation = {:.0f}), draw the target's thin parts "
        "at least four cells wide, or raise terrain.samples.",
        100.0 * (1.0 - report.score.recall), degrees(report.sun.elevation),
        elevation_for(report.sun, 1.0 / std::max(report.score.recall, 0.2)));
}

std::string about_shadow(const ShadowReport& report) {
    return fmt::format(
        " {:.0f}% of the shadow falls outside the target: land that belongs to no caster "
        "is steeper than a sun at {:.1f} degrees allows. Raise the sun (try elevation = "
        "{:.0f}), or calm the base: fewer and lower features, smoother noise.",
        100.0 * (1.0 - report.score.precision), degrees(report.sun.elevation),
        elevation_for(report.sun, std::max(report.score.precision, 0.2)));
}

std::string about_surroundings(const ShadowReport& report) {
    return fmt::format(
        "The shadow of '{}' has its shape (IoU {:.3f}) but is lost among the land's own: "
        "it stands out from other silhouettes by {:.1f} standard deviations, {:.0f} are "
        "wanted. Calm the base, raise the sun (try elevation = {:.0f}) or scale the "
        "image up. overlay.png shows the shadows around its window in grey.",
        report.name, report.score.iou, *report.standing_out, kLeastStandingOut,
        elevation_for(report.sun, 0.7));
}

}  // namespace

bool ShadowReport::passed() const {
    const bool drowned =
        min_iou > 0.0 && standing_out.value_or(kLeastStandingOut) < kLeastStandingOut;
    return score.iou >= min_iou && !drowned;
}

std::vector<ShadowReport> check(const Terrain& terrain, const fs::path& folder) {
    check_request(terrain);
    if (terrain.shadows.empty()) return {};
    const CheckedLand land(terrain.heights, terrain.spacing);
    const Field<float> ground = relief(land.heights, land.spacing);
    std::vector<ShadowReport> reports;
    for (const ShadowImage& image : terrain.shadows) {
        const Mask cast = land.caster.shadow(image.sun, kCheckRays);
        const auto place = place_of(terrain, image, folder);
        make_folder(place);
        write_mask(place / "cast.png", cast);
        write_mask(place / "target.png", repeated(image.target, kCheckRays));
        write_png(place / "overlay.png", overlay(cast, image, ground));
        if (!image.window.empty()) write_window(place / "window.png", image.window);
        reports.push_back({image.name,
                           image.sun,
                           image.min_iou,
                           score(cast, image.target, image.window),
                           relaxed(image).share,
                           rival_of(image, terrain.shadows),
                           {}});
    }
    return reports;
}

std::vector<ShadowFigures> measure(const Terrain& terrain, const Field<float>* base,
                                   const fs::path& folder, Progress& progress) {
    check_request(terrain);
    if (terrain.shadows.empty()) return {};
    const CheckedLand land(terrain.heights, terrain.spacing);
    std::optional<CheckedLand> before;
    if (base) before.emplace(*base, terrain.spacing);
    std::vector<ShadowFigures> all;
    const double parts = 2.0 * static_cast<double>(terrain.shadows.size());
    for (const ShadowImage& image : terrain.shadows) {
        progress.report(2.0 * static_cast<double>(all.size()) / parts);
        all.push_back(shadow_figures(land, before ? &*before : nullptr, image));
        progress.report((2.0 * static_cast<double>(all.size()) - 1.0) / parts);
        const auto place = place_of(terrain, image, folder);
        make_folder(place);
        write_png(place / "sun-clock.png", sun_clock(land, image.sun));
    }
    progress.report(1.0);
    return all;
}

std::string advice(const ShadowReport& report) {
    if (report.passed()) return {};
    const auto [iou, precision, recall] = report.score;
    if (iou >= report.min_iou) return about_surroundings(report);
    std::string text = fmt::format(
        "The shadow of '{}' matches its target with IoU {:.3f} (precision {:.3f}, recall "
        "{:.3f}); {:.3f} is wanted.",
        report.name, shown(iou), precision, recall, report.min_iou);
    if (report.relaxed > 0.0) text += about_rivals(report);
    if (recall <= precision) text += about_light(report);
    if (precision <= recall) text += about_shadow(report);
    text += " overlay.png shows where: blue hit, yellow missed, pink spurious";
    return text + (report.relaxed > 0.0 ? ", violet gave way." : ".");
}

}  // namespace cydonia::render
