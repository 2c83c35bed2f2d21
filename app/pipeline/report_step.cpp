// Fills the struct of the page (render/report) from the ledger and the files of steps.
#include "app/pipeline/report_step.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/pipeline/memory.h"
#include "app/pipeline/shadow_report.h"
#include "field/data.h"
#include "field/files.h"
#include "render/report/report.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr int kFramePixels = 1440, kPicturePixels = 960, kMaskPixels = 384;
// Bytes. A larger video is not embedded but played from its file.
constexpr std::uint64_t kCarriedVideo = 3u << 19;  // 1.5 MB

struct Finished {
    std::string id;
    StepRecord record;
};
using All = std::vector<Finished>;

All finished_of(Graph& graph) {
    All all;
    for (const Need& need : graph.step(kReportStep).needs)
        if (const StepRecord* record = graph.finished(need.id))
            all.push_back({need.id, *record});
    return all;
}

const StepRecord* find(const All& all, const std::string& id) {
    const auto found = std::ranges::find(all, id, &Finished::id);
    return found == all.end() ? nullptr : &found->record;
}

// Everything on the page apart from the results of steps.
Key key_of(const Job& job) {
    KeyBuilder key("report");
    key.add(job.program).add(job.spec->title).add(job.spec->seed);
    key.add(job.request.overrides).add(hash_of_bytes(render::three_js()));
    std::vector<fs::path> data;
    for (const auto& file : fs::directory_iterator(data_folder("report")))
        data.push_back(file.path());
    std::ranges::sort(data);
    for (const fs::path& file : data) key.add(hash_of_file(file));
    return key.key();
}

// The scene in canonical form, as in a scene file.
std::string scene_text(const config::SceneSpec& spec) {
    std::string text = fmt::format(
        "title = {}\nseed = {}\n\n[terrain]\nextent = [{}, {}]  # metres\nsamples = {}\n",
        Json(spec.title).dump(-1, ' ', false, Json::error_handler_t::replace), spec.seed,
        spec.terrain.width, spec.terrain.depth, spec.terrain.samples);
    for (const config::StageSpec& stage : spec.stages)
        text += "\n[[terrain.stage]]\n" + stage.text;
    text += "\n[render]\n" + spec.render_text;
    return text + "\n[frames]\n" + spec.frames_text;
}

std::string spaced(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

// Adds a row for every value in `json`, however deep.
void add_rows(const std::string& name, const Json& json,
              std::vector<render::ReportRow>& rows) {
    const auto below = [&](const std::string& part) {
        return name.empty() ? part : name + ", " + part;
    };
    if (json.is_object()) {
        for (const auto& [key, value] : json.items())
            add_rows(below(spaced(key)), value, rows);
    } else if (json.is_array() && std::ranges::any_of(json, [](const Json& part) {
                   return part.is_structured();
               })) {
        for (std::size_t i = 0; i < json.size(); ++i)
            add_rows(below(fmt::format("{}", i + 1)), json[i], rows);
    } else if (json.is_array()) {
        std::string values;
        for (const Json& part : json)
            values += (values.empty() ? "" : ", ") + part.dump();
        rows.push_back({name, values});
    } else if (json.is_number_float()) {
        rows.push_back({name, fmt::format("{:.5g}", json.get<double>())});
    } else if (!json.is_null()) {
        rows.push_back({name, json.is_string() ? json.get<std::string>() : json.dump()});
    }
}

std::vector<render::ReportTable> figures_of(const All& all) {
    std::vector<render::ReportTable> tables;
    const auto add = [&tables](const std::string& title, const Json& json) {
        render::ReportTable table{title, {}};
        add_rows("", json, table.rows);
        std::erase_if(table.rows, [](const auto& row) { return row.value.empty(); });
        if (!table.rows.empty()) tables.push_back(std::move(table));
    };
    for (const Finished& step : all) {
        if (step.id == "check") {
            for (const Json& image : step.record.result.at("images"))
                add(fmt::format("Shadow of {}", image.at("name").get<std::string>()),
                    image);
        } else if (!step.id.starts_with("plan ")) {  // too long: a line for every frame
            add(step.id, step.record.result);
        }
    }
    return tables;
}

std::string verdict_of(const render::ShadowReport& report) {
    return fmt::format(
        "With the sun at azimuth {:.4g}° and elevation {:.4g}°, shadow and image share "
        "{:.1f}% of the area that either darkens; {:.0f}% is asked for{}.",
        degrees(report.sun.azimuth), degrees(report.sun.elevation),
        std::floor(1000.0 * report.score.iou) / 10.0, 100.0 * report.min_iou,
        report.passed() ? "" : ", and it falls short");
}

// A black and white picture, scaled to the land: 1 where it is dark, or else white.
Field<std::uint8_t> flags_of(const fs::path& picture, const Field<float>& land,
                             bool dark) {
    const Field<float> grey =
        resized(read_grey(open_source(picture)), land.width(), land.height());
    Field<std::uint8_t> flags(land.width(), land.height());
    std::ranges::transform(grey, flags.begin(), [dark](float value) -> std::uint8_t {
        return (value < 0.5f) == dark;
    });
    return flags;
}

class Filling {
  public:
    Filling(const Job& job, const All& all) : job_(job), all_(all) {}

    render::Report filled() {
        report_.title = job_.spec->title;
        report_.version = kVersion;
        report_.scene = scene_text(*job_.spec);
        report_.three = render::three_js();
        report_.figures = figures_of(all_);
        add_land();
        add_images();
        add_frames();
        add_videos();
        add_steps();
        return std::move(report_);
    }

  private:
    render::ReportPicture picture(const std::string& file, const std::string& label,
                                  int most) const {
        return render::report_picture(job_.folder, file, label, most);
    }

    void add_land() {
        const StepRecord* land = find(all_, "terrain");
        if (!land) return;
        const Json& measured = land->result;
        const auto number = [&](const char* name, int i) {
            return measured.at(name).at(static_cast<std::size_t>(i)).get<double>();
        };
        report_.facts = {{"Land", fmt::format("{:.6g} × {:.6g} m", number("extent", 0),
                                              number("extent", 1))},
                         {"Samples", fmt::format("{} × {}", number("samples", 0),
                                                 number("samples", 1))},
                         {"Heights", fmt::format("{:.0f} to {:.0f} m",
                                                 measured.at("lowest").get<double>(),
                                                 measured.at("highest").get<double>())},
                         {"Seed", fmt::format("{}", job_.spec->seed)},
                         {"Quality", std::string(name_of(job_.request.quality))}};

        Field<float> heights = read_exr(job_.folder / "terrain.exr");
        const int longer = std::max(heights.width(), heights.height());
        report_.spacing = measured.at("spacing");
        if (longer > render::kReportSamples) {
            const double share = double(render::kReportSamples) / longer;
            const auto side = [&](int samples) {
                return std::max(2, static_cast<int>(std::lround(samples * share)));
            };
            report_.spacing /= share;
            heights = resized(heights, side(heights.width()), side(heights.height()));
        }
        if (std::min(heights.width(), heights.height()) >= 2)
            report_.heights = std::move(heights);
        report_.sun = job_.spec->render.sun.value_or(Sun{radians(315.0), radians(35.0)});

        report_.relief.push_back(picture("preview.png", "shaded relief", kPicturePixels));
        for (const std::string& file : land->outputs) {
            if (!file.starts_with("masks/")) continue;
            report_.relief.push_back(
                picture(file, fs::path(file).stem().string(), kMaskPixels));
            if (file == "masks/water.png" && !report_.heights.empty())
                report_.water = flags_of(job_.folder / file, report_.heights, false);
        }
    }

    void add_images() {
        const StepRecord* check = find(all_, "check");
        if (!check) return;
        const Json& images = check->result.at("images");
        for (const Json& json : images) {
            const render::ShadowReport checked = report_of(json);
            const std::string folder =
                images.size() == 1 ? "shadow/" : "shadow/" + checked.name + "/";
            render::ReportImage image{
                checked.name, checked.sun, verdict_of(checked), checked.passed(), {},
                {},           {}};
            if (!report_.heights.empty()) {
                image.target = flags_of(job_.folder / (folder + "target.png"),
                                        report_.heights, true);
                const std::string window = folder + "window.png";
                if (std::ranges::find(check->outputs, window) != check->outputs.end())
                    image.window = flags_of(job_.folder / window, report_.heights, false);
            }
            for (const auto& [file, label, most] :
                 {std::tuple{"overlay.png", "shadow and image over one another",
                             kPicturePixels},
                  {"cast.png", "the shadow", kMaskPixels},
                  {"target.png", "the image", kMaskPixels},
                  {"sun-clock.png", "twelve suns of one day", kFramePixels}})
                image.pictures.push_back(picture(folder + file, label, most));
            report_.images.push_back(std::move(image));
        }
        if (!report_.images.empty()) report_.sun = report_.images.front().sun;
    }

    void add_frames() {
        for (const Finished& step : all_) {
            if (!step.id.starts_with("deliver ") && !step.id.starts_with("preview "))
                continue;
            for (const std::string& file : step.record.outputs)
                if (file.ends_with(".png"))
                    report_.frames.push_back(
                        picture(file, fs::path(file).stem().string(), kFramePixels));
        }
    }

    void add_videos() {
        for (const Finished& step : all_) {
            if (!step.id.starts_with("video ")) continue;
            for (const std::string& file : step.record.outputs)
                if (file.ends_with(".mp4")) report_.videos.push_back(video(file));
        }
    }

    // The poster is the frame at which the video pauses, else the first.
    render::ReportVideo video(const std::string& file) const {
        const std::string name = fs::path(file).stem().string();
        const std::string sequence = name.substr(0, name.find('-'));
        std::string number = "-0001";
        if (const StepRecord* plan = find(all_, "plan " + sequence))
            number =
                plan->result.at("key_frame").get<std::string>().substr(sequence.size());
        render::ReportVideo video{name, file, {}, {}};
        std::ranges::replace(video.label, '-', ' ');
        const std::string still = "frames/" + name + number + ".png";
        if (std::error_code none; fs::exists(job_.folder / still, none))
            video.poster = picture(still, name, kPicturePixels);
        if (fs::file_size(job_.folder / file) <= kCarriedVideo)
            video.mp4 = read_text(job_.folder / file);
        return video;
    }

    void add_steps() {
        const auto stages = static_cast<std::size_t>(job_.land.stages());
        for (const Finished& step : all_) {
            const std::size_t number = std::strtoul(step.id.c_str(), nullptr, 10);
            const bool stage = number >= 1 && number <= stages;
            (stage ? report_.stages : report_.other_steps)
                .push_back({step.id, step.record.seconds,
                            stage ? job_.spec->stages[number - 1].text : ""});
        }
    }

    const Job& job_;
    const All& all_;
    render::Report report_;
};

}  // namespace

Step report_step(const Job& job) {
    const auto run = [&job](Graph& graph) -> StepResult {
        const All all = finished_of(graph);
        write_text(job.folder / "report.html",
                   render::report_page(Filling(job, all).filled()));
        return {{"report.html"}};
    };
    return {
        .id = kReportStep,
        .memory = memory::of_export(job.cells()) + memory::of_delivery(most_pixels(job)),
        .key = [&job] { return key_of(job); },
        .run = run};
}

}  // namespace cydonia
