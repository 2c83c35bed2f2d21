#include "app/pipeline/height_check.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/pipeline/memory.h"
#include "app/pipeline/output_folder.h"
#include "app/pipeline/shadow_report.h"
#include "app/threads.h"
#include "field/dem.h"
#include "field/image.h"
#include "field/strokes.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

Sun sun_of(const HeightCheck& asked) {
    if (!(asked.elevation > 0.0 && asked.elevation < 90.0)) {
        throw bad_request(
            "--sun: an elevation of {} degrees casts no shadow; give one above 0 and "
            "below "
            "90",
            asked.elevation);
    }
    return {radians(asked.azimuth), radians(asked.elevation)};
}

std::string stem_word(const fs::path& file) {
    std::string word = file.stem().string();
    std::ranges::replace_if(
        word, [](unsigned char c) { return !std::isalnum(c) && c != '-' && c != '_'; },
        '_');
    return word.empty() ? "target" : word;
}

// A target of another size is resampled to the land's cells, and that is said.
void note_resampling(const Source& target, const Terrain& terrain, Progress& progress) {
    const int width = terrain.heights.width(), height = terrain.heights.height();
    if (target.path.extension() == ".svg") return;
    const Field<float> image = read_grey(target);
    if (image.width() == width && image.height() == height) return;
    progress.note(fmt::format("{} has {}x{} pixels: stretched to the land's {}x{} cells",
                              target.name(), image.width(), image.height(), width,
                              height));
}

ShadowImage image_asked(const Source& target, const Sun& sun, const Terrain& terrain) {
    const Field<float> grey =
        read_grey_at(target, terrain.heights.width(), terrain.heights.height());
    ShadowImage image{stem_word(target.path), {grey.width(), grey.height()}, sun};
    std::ranges::transform(grey, image.target.begin(),
                           [](float value) { return value < 0.5f ? 1 : 0; });
    if (std::ranges::count(image.target, 1) == 0) {
        throw bad_request("{}: no pixel is dark, so there is no shadow to find",
                          target.path.string());
    }
    return image;
}

void check_here(const HeightCheck& asked, const Request& request, Progress& progress) {
    const Sun sun = sun_of(asked);
    const Source height = open_source(asked.height), target = open_source(asked.target);
    const fs::path folder = request.output.empty()
                                ? fs::path("out") / stem_word(asked.height)
                                : request.output;
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
    note_resampling(target, terrain, progress);
    terrain.shadows = {image_asked(target, sun, terrain)};

    const OutputFolder claim(folder);
    progress.step("check");
    const auto reports = render::check(terrain, folder / "shadow", progress);
    for (const render::ShadowReport& report : reports) progress.note(score_text(report));
    if (!request.force) stop_when_short(reports, folder / "shadow");
}

}  // namespace

void check_height(const HeightCheck& asked, const Request& request, Progress& progress) {
    with_threads(request.threads, [&] { check_here(asked, request, progress); });
}

}  // namespace cydonia
