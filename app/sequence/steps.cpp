#include "app/sequence/steps.h"

#include <fmt/core.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/gallery/contact_sheet.h"
#include "app/pipeline/cache.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/shadow_report.h"
#include "app/sequence/day.h"
#include "app/sequence/filming.h"
#include "app/sequence/share.h"
#include "app/sequence/timeline.h"
#include "app/sequence/turntable.h"
#include "field/error.h"
#include "field/files.h"
#include "render/cameras.h"
#include "render/frames/povray.h"
#include "render/frames/video.h"

namespace cydonia {
namespace {

constexpr std::size_t kSheetFrames = 48;  // at most, evenly
constexpr std::size_t kSheetBytes = 400000;
constexpr std::array<const char*, 3> kVideos = {".mp4", ".webp", ".gif"};

Goal goal_of(Kind kind) {
    constexpr Goal kGoals[] = {Goal::kSweep, Goal::kTurntable, Goal::kFilm};
    return kGoals[static_cast<int>(kind)];
}

struct Plan {
    Sequence sequence;
    std::vector<std::string> news = {};
    bool appears = true;  // the first image of a day
};

// A turntable's camera may be none of the scene's.
Sequence sized(Sequence sequence, const Job& job) {
    for (Shot& shot : sequence.shots) {
        job.resize(shot.camera);
        job.resize(*shot.next);
        for (render::CameraOptions& moment : shot.moments) job.resize(moment);
    }
    return sequence;
}

// A day follows the suns of images, which stages choose: its land is made first.
Plan plan_of(Kind kind, Job& job) {
    switch (kind) {
        case Kind::kDay: {
            Day day =
                day_over(job.spec.frames, filming_camera(job.spec.frames, job.cameras()),
                         job.land.finished().shadows);
            return {std::move(day.sequence), std::move(day.news), day.appears};
        }
        case Kind::kTurntable:
            return {sized(turntable(job.spec.frames, job.cameras()), job)};
        case Kind::kFilm:
            break;
    }
    Timeline film = timeline({[&job](double frame) { return job.at(frame); },
                              job.scene.varies(), job.scene.last_key()},
                             job.spec, job.cameras());
    return {std::move(film.sequence), std::move(film.news)};
}

void check(Kind kind, Job& job) {
    if (kind == Kind::kDay) check_day(job.spec);
    const int count = kind == Kind::kFilm
                          ? static_cast<int>(plan_of(kind, job).sequence.shots.size())
                          : job.spec.frames.count.value_or(config::FramesSpec::kCount);
    check_names(job.spec, name_of(kind), count);
}

// A camera that would be under the ground somewhere is better refused now.
void place_all(const Sequence& sequence, Job& job) {
    const Terrain& terrain = job.land.drawn();
    for (const Shot& shot : sequence.shots) {
        if (shot.scene) continue;  // over a land that may not be made yet
        try {
            render::place(shot.camera, terrain, job.request.quality,
                          job.spec.render.water);
        } catch (const Error& error) {
            throw bad_request("{}: {}", shot.camera.name, error.what());
        }
    }
}

Json json_of(const Plan& plan) {
    const Sequence& sequence = plan.sequence;
    Json shots = Json::array();
    for (const Shot& shot : sequence.shots) {
        Json told = {{"frame", shot.camera.name}};
        if (!shot.when.empty()) told["when"] = shot.when;
        if (shot.camera.sun) told["sun"] = json_of(*shot.camera.sun);
        if (shot.camera.turn != 0.0) told["turn"] = degrees(shot.camera.turn);
        shots.push_back(std::move(told));
    }
    const auto still = static_cast<std::size_t>(sequence.still);
    return {{"camera", sequence.camera},
            {"news", plan.news},
            {"appears", plan.appears},
            {"key_frame", sequence.shots.at(still).camera.name},
            {"shots", std::move(shots)}};
}

void tell(const Json& plan, Progress& progress) {
    for (const Json& sentence : plan.at("news")) {
        const auto text = sentence.get<std::string>();
        if (text.find("does not appear") == text.npos)
            progress.note(text);
        else
            progress.warn(text);
    }
}

// Of numbered PNGs.
struct Reel {
    std::string name;
    std::vector<std::string> frames;  // files in the output folder
};

Reel reel_of(const Job& job, const Sequence& sequence) {
    Reel reel{sequence.name, {}};
    if (job.request.preview)
        reel.name += '-' + std::string(name_of(*job.request.preview));
    for (std::size_t i = 0; i < sequence.shots.size(); ++i)
        reel.frames.push_back("frames/" + frame_name(reel.name, static_cast<int>(i)) +
                              ".png");
    return reel;
}

void write_sheet(const Job& job, const Reel& reel, const std::string& file) {
    const std::size_t tiles = std::min(reel.frames.size(), kSheetFrames);
    std::vector<Tile> sheet;
    for (std::size_t i = 0; i < tiles; ++i) {
        const std::string& frame = reel.frames[i * reel.frames.size() / tiles];
        const Field<Rgba8> picture = read_rgba(open_source(job.folder / frame));
        Tile tile{std::filesystem::path(frame).stem().string(),
                  Field<Rgb8>(picture.width(), picture.height())};
        std::ranges::transform(picture, tile.picture.begin(), [](const Rgba8& pixel) {
            return Rgb8{pixel[0], pixel[1], pixel[2]};
        });
        sheet.push_back(std::move(tile));
    }
    write_text(job.folder / file, jpeg_within(contact_sheet(sheet), kSheetBytes));
}

Made encode(Kind kind, Job& job) {
    const Sequence sequence = plan_of(kind, job).sequence;
    const Reel reel = reel_of(job, sequence);
    const render::Film film{
        job.folder / "frames", reel.name,      static_cast<int>(reel.frames.size()),
        sequence.rate,         sequence.still, sequence.hold};
    Made made;
    made.outputs.push_back("frames/" + reel.name + ".jpg");
    write_sheet(job, reel, made.outputs.back());
    // Small films take less than a core each.
    Share share(kVideos.size(), job.progress);
    tbb::parallel_for(std::size_t{0}, kVideos.size(), [&](std::size_t i) {
        FrameProgress progress(i, 1.0, share);
        render::encode_video(film, job.folder / "frames" / (reel.name + kVideos[i]),
                             progress);
    });
    for (const char* extension : kVideos)
        made.outputs.push_back("frames/" + reel.name + extension);
    return made;
}

// What the frames of a film are made from; the other sequences' follow from the scene.
std::string timeline_text(Job& job) try {
    std::string text;
    for (const Shot& shot : plan_of(Kind::kFilm, job).sequence.shots) {
        text += text_of(shot.camera, {.moments = shot.moments}) + '\n';
        if (!shot.scene) continue;
        const Land land = job.land_of(*shot.scene, job.progress);
        text += fmt::format("{:016x}\n{}\n", land.drawn_key(), shot.scene->render_text);
    }
    return text;
} catch (const Error&) {
    return "nothing to film";  // check() says why
}

std::string size_text(const Request& request) {
    return request.size ? fmt::format("{}x{}", (*request.size)[0], (*request.size)[1])
                        : "by quality";
}

std::uint64_t key_of(Job& job, Kind kind, const std::string& what) {
    const render::ColourOptions& colour = job.spec.render.colour;
    const std::string style =
        job.request.preview ? std::string(name_of(*job.request.preview)) : "povray";
    return hash_text(
        fmt::format("{} {:016x} {:016x} {} {} {} {} {} {:016x} {}\n{}\n{}\n{}", what,
                    job.land.key(), job.program, name_of(job.request.quality), style,
                    size_text(job.request), job.spec.title, job.spec.name, ocio_hash(),
                    colour.config ? colour.config->hash : 0, job.spec.render_text,
                    job.spec.frames_text, kind == Kind::kFilm ? timeline_text(job) : ""));
}

// The frames are worth having without it, and the user waits for them already.
void look_for_ffmpeg(Progress& progress) try {
    render::ffmpeg_program();
} catch (const Error& error) {
    progress.warn(fmt::format("{}; the frames are made, the video is not", error.what()));
}

std::uint64_t most_pixels(const Job& job) {
    std::uint64_t most = 0;
    for (const render::CameraOptions& camera : job.cameras())
        most = std::max(most, static_cast<std::uint64_t>(camera.size[0]) *
                                  static_cast<std::uint64_t>(camera.size[1]));
    return most;
}

std::vector<Step> steps_of(Kind kind, Job& job) {
    const std::string name = name_of(kind);
    const Goal goal = goal_of(kind);
    const std::uint64_t pixels = most_pixels(job);
    const std::uint64_t filming =
        job.request.preview ? memory::of_passes(job.drawn_cells(), pixels)
                            : std::max(memory::of_emit(job.drawn_cells()),
                                       memory::of_trace(job.drawn_cells(), pixels));
    // Of one look and of another they are other frames.
    const std::string look =
        job.request.preview ? " " + std::string(name_of(*job.request.preview)) : "";
    return {{.name = "plan " + name,
             .goal = goal,
             .memory = memory::of_export(job.cells()),
             .key = [&job, kind] { return key_of(job, kind, "plan"); },
             .run =
                 [&job, kind] {
                     const Plan plan = plan_of(kind, job);
                     place_all(plan.sequence, job);
                     return Made{{}, json_of(plan)};
                 },
             .gate = [&job](const Json& plan) { tell(plan, job.progress); },
             .before = [&job, kind] { check(kind, job); }},
            {.name = "film " + name + look,
             .goal = goal,
             .memory = filming,
             .key = [&job, kind] { return key_of(job, kind, "film"); },
             .run =
                 [&job, kind] {
                     const Sequence sequence = plan_of(kind, job).sequence;
                     return job.request.preview
                                ? film_by_embree(job, sequence, *job.request.preview)
                                : film_by_povray(job, sequence);
                 },
             .before =
                 [&job] {
                     if (!job.request.preview) render::povray_program();
                 }},
            {.name = "video " + name + look,
             .goal = goal,
             .memory = memory::of_delivery(pixels),
             .key = [&job, kind] { return key_of(job, kind, "video"); },
             .run = [&job, kind] { return encode(kind, job); },
             .before = [&job] { look_for_ffmpeg(job.progress); }}};
}

}  // namespace

std::vector<Step> sequence_steps(Job& job) {
    std::vector<Step> steps;
    for (const Kind kind : {Kind::kDay, Kind::kTurntable, Kind::kFilm})
        for (Step& step : steps_of(kind, job)) steps.push_back(std::move(step));
    return steps;
}

}  // namespace cydonia
