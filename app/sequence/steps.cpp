#include "app/sequence/steps.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/pipeline/cache.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/shadow_report.h"
#include "app/sequence/filming.h"
#include "app/sequence/plan.h"
#include "app/sequence/reel.h"
#include "field/error.h"
#include "render/cameras/cameras.h"
#include "render/frames/povray.h"
#include "render/frames/video.h"

namespace cydonia {
namespace {

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
    return "nothing to film";  // check_plan() says why
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
        fmt::format("{} {} {:016x} {:016x} {} {} {} {} {} {:016x} {}\n{}\n{}\n{}", what,
                    job.request.frames ? job.request.frames->last : -1, job.land.key(),
                    job.program, name_of(job.request.quality), style,
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
    std::string frames = name;
    if (job.request.preview) frames += fmt::format(" {}", name_of(*job.request.preview));
    if (const auto& asked = job.request.frames)
        frames += fmt::format(" {}-{}", asked->first, asked->last);
    std::vector<Step> steps = {
        {.name = "plan " + name,
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
         .before = [&job, kind] { check_plan(kind, job); }},
        {.name = (job.request.trace_only ? "trace " : "film ") + frames,
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
             }}};
    if (!job.request.frames)
        steps.push_back(
            {.name = "video " + frames,
             .goal = goal,
             .memory = memory::of_delivery(pixels),
             .key = [&job, kind] { return key_of(job, kind, "video"); },
             .run = [&job, kind] { return encode(plan_of(kind, job).sequence, job); },
             .before = [&job] { look_for_ffmpeg(job.progress); }});
    return steps;
}

}  // namespace

std::vector<Step> sequence_steps(Job& job) {
    std::vector<Step> steps;
    for (const Kind kind : {Kind::kDay, Kind::kTurntable, Kind::kFilm})
        for (Step& step : steps_of(kind, job)) steps.push_back(std::move(step));
    return steps;
}

}  // namespace cydonia
