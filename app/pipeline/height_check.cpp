#include "app/pipeline/height_check.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/pipeline/memory.h"
#include "app/pipeline/output_folder.h"
#include "app/pipeline/shadow_report.h"
#include "app/threads.h"
#include "field/dem.h"
#include "field/strokes.h"
#include "synth/pareidolia/target.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

Sun sun_of(const HeightCheck& asked) {
    if (!(asked.elevation > 0.0 && asked.elevation < 90.0)) {
        throw bad_request(
            "--sun: an elevation of {} degrees casts no shadow; give one above 0 and "
            "below 90",
            asked.elevation);
    }
    return {radians(asked.azimuth), radians(asked.elevation)};
}

// 1 where shadows count; empty: everywhere.
Field<std::uint8_t> window_asked(const HeightCheck& asked, const Terrain& terrain) {
    if (asked.window.empty()) return {};
    const Field<float> grey = read_grey_at(
        open_source(asked.window), terrain.heights.width(), terrain.heights.height());
    Field<std::uint8_t> window(grey.width(), grey.height());
    std::ranges::transform(grey, window.begin(), [](float g) { return g >= 0.5f; });
    if (std::ranges::none_of(window, [](auto w) { return w != 0; }))
        throw bad_request("--window: {} has no white pixels, so no shadow would count",
                          asked.window.string());
    return window;
}

ShadowImage image_asked(const Source& target, const Sun& sun, const Terrain& terrain,
                        Progress& progress) {
    pareidolia::ImageOptions options;
    options.target = target;
    return {pareidolia::image_name(options),
            pareidolia::shadow_target(options, terrain.heights.width(),
                                      terrain.heights.height(), progress),
            sun};
}

void check_here(const HeightCheck& asked, const Request& request, Progress& progress) {
    const Sun sun = sun_of(asked);
    const Source height = open_source(asked.height), target = open_source(asked.target);
    const fs::path folder =
        request.output.empty() ? fs::path("out") / asked.height.stem() : request.output;
    if (request.dry_run) {
        fmt::print("{} against {}, to {}\n", asked.height.string(), asked.target.string(),
                   (folder / "shadow").string());
        return;
    }

    progress.step("read " + height.name());
    std::string note;
    Terrain terrain = read_dem(height, &note);
    if (!note.empty()) progress.note(note);
    memory::refuse_unless_it_fits(memory::of_check(terrain.heights.size()),
                                  memory::available());
    terrain.shadows = {image_asked(target, sun, terrain, progress)};
    terrain.shadows.front().window = window_asked(asked, terrain);

    const OutputFolder claim(folder);
    progress.step("check");
    const CheckedShadows checked =
        check_shadows(terrain, nullptr, folder / "shadow", progress);
    if (!request.force) stop_when_short(checked.reports, folder / "shadow");
}

}  // namespace

void check_height(const HeightCheck& asked, const Request& request, Progress& progress) {
    with_threads(request.threads, [&] { check_here(asked, request, progress); });
}

}  // namespace cydonia
