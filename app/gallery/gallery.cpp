#include "app/gallery/gallery.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cstring>
#include <system_error>

#include "app/gallery/contact_sheet.h"
#include "app/gallery/page.h"
#include "app/pipeline/output_folder.h"
#include "app/pipeline/pipeline.h"
#include "app/pipeline/steps.h"
#include "field/data.h"
#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr const char* kFolder = "out/gallery";
constexpr int kThumbnail = 640;               // pixels of the longer side
constexpr int kThumbnailQuality = 85;         // of its JPEG
constexpr std::size_t kSheetBytes = 150'000;  // small enough for a README

// Shows all steps of a scene as one line.
class OneLine final : public Progress {
  public:
    OneLine(Console& console, std::string name)
        : console_(console), name_(std::move(name)) {
        console_.step(name_);
    }
    void expect(std::size_t steps) { expected_ = static_cast<int>(steps); }

    void step(std::string_view) override { ++begun_; }
    void report(double fraction) override {
        const int begun = begun_;
        console_.report((begun - 1 + fraction) / std::max(expected_, begun));
    }
    void note(std::string_view) override {}
    void warn(std::string_view sentence) override {
        console_.warn(fmt::format("{}: {}", name_, sentence));
    }

  private:
    Console& console_;
    std::string name_;
    int expected_ = 0;
    std::atomic<int> begun_{0};
};

std::vector<fs::path> scenes_in(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> scenes;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const fs::path scene = entry.path() / "scene.toml";
        if (std::error_code none; fs::exists(scene, none)) scenes.push_back(scene);
    }
    if (scenes.empty()) {
        throw bad_request("no scene in {} (looked for */scene.toml{})", folder.string(),
                          error ? ": " + error.message() : "");
    }
    std::ranges::sort(scenes);
    return scenes;
}

// A path as one types it: relative if it is below here, quoted if a shell needs it.
std::string typed(const fs::path& path) {
    const fs::path relative = fs::proximate(path);
    const std::string text = (*relative.begin() == ".." ? path : relative).string();
    const bool plain = std::ranges::all_of(
        text, [](unsigned char c) { return std::isalnum(c) || std::strchr("/._-+", c); });
    if (plain) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

Field<Rgb8> read_rgb(const fs::path& file) {
    const Field<Rgba8> image = read_rgba(open_source(file));
    Field<Rgb8> rgb(image.width(), image.height());
    std::ranges::transform(image, rgb.begin(), [](const Rgba8& p) {
        return Rgb8{p[0], p[1], p[2]};
    });
    return rgb;
}

void write_thumbnail(const fs::path& from, const fs::path& to) {
    make_folder(to.parent_path());
    const Field<Rgb8> small = fitted(read_rgb(from), kThumbnail, kThumbnail);
    write_text(to, jpeg_of(small, kThumbnailQuality));
}

void add_pictures(const Job& job, Exhibit& exhibit) {
    const auto add = [&](const fs::path& from, const std::string& name,
                         const std::string& label) {
        const std::string file = "thumbnails/" + name + ".jpg";
        write_thumbnail(from, fs::path(kFolder) / file);
        exhibit.pictures.push_back({file, label});
    };
    for (const render::CameraOptions& camera : job.cameras()) {
        add(job.folder / "frames" / (camera.name + ".png"),
            exhibit.name + "/" + camera.name, camera.name);
    }
    add(job.folder / "preview.png", exhibit.name, "the land as shaded relief");
}

double seconds_of(const std::vector<const Step*>& steps, Graph& graph) {
    double seconds = 0.0;
    for (const Step* step : steps)
        if (const StepRecord* record = graph.finished(step->id))
            seconds += record->seconds;
    return seconds;
}

void make_scene(const Request& request, OneLine& line, Exhibit& exhibit) {
    exhibit.about = leading_comment(read_text(request.scene));
    const Job job(request, line);
    exhibit.title = job.spec->title;
    Ledger ledger(job.folder);
    Graph graph(steps_of(job), ledger);
    std::vector<const Step*> frames = graph.closure(targets_of(Goal::kFrames, job));
    line.expect(frames.size());
    make(request, Goal::kFrames, line);
    ledger.reload();
    const auto land = graph.closure(targets_of(Goal::kTerrain, job));
    std::erase_if(frames, [&](const Step* step) {
        return std::ranges::find(land, step) != land.end() || step->id == kCheckStep ||
               step->id == kReportStep;
    });
    exhibit.synthesis += seconds_of(land, graph);
    exhibit.render += seconds_of(frames, graph);
    add_pictures(job, exhibit);
}

Exhibit exhibit_of(const Request& request, Console& console) {
    Exhibit exhibit;
    exhibit.name = exhibit.title = request.scene.parent_path().filename().string();
    exhibit.command = fmt::format("cydonia render {} --quality {}", typed(request.scene),
                                  name_of(request.quality));
    OneLine line(console, exhibit.name);
    try {
        make_scene(request, line, exhibit);
    } catch (const std::exception& error) {
        exhibit.failure = error.what();
        console.warn(exhibit.name + " could not be made");
    }
    return exhibit;
}

void write_contact_sheet(const std::vector<Exhibit>& exhibits) {
    std::vector<Tile> tiles;
    for (const Exhibit& e : exhibits) {
        if (e.pictures.empty()) continue;
        tiles.push_back({e.name, read_rgb(fs::path(kFolder) / e.pictures.front().file)});
    }
    if (tiles.empty()) return;
    const Field<Rgb8> sheet = contact_sheet(tiles);
    write_png(fs::path(kFolder) / "contact-sheet.png", sheet);
    write_text(fs::path(kFolder) / "contact-sheet.jpg", jpeg_within(sheet, kSheetBytes));
}

void fail_for(const std::vector<Exhibit>& exhibits) {
    std::string reasons;
    for (const Exhibit& e : exhibits) {
        if (!e.failure.empty()) reasons += fmt::format("\n{}: {}", e.name, e.failure);
    }
    if (!reasons.empty()) throw failure("not every scene could be made{}", reasons);
}

}  // namespace

void make_gallery(const fs::path& scenes, const Request& each, Console& console) {
    const auto files = scenes_in(scenes.empty() ? data_folder("scenes") : scenes);
    const OutputFolder claim(kFolder);
    std::vector<Exhibit> exhibits;
    for (const fs::path& file : files) {
        Request request = each;
        request.scene = file;
        exhibits.push_back(exhibit_of(request, console));
    }
    console.step("contact sheet and page");
    write_contact_sheet(exhibits);
    write_text(fs::path(kFolder) / "index.html", page_of(exhibits));
    console.finish();
    console.note(fmt::format("in {}", kFolder));
    fail_for(exhibits);
}

}  // namespace cydonia
