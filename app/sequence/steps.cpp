#include "app/sequence/steps.h"

#include <fmt/core.h>

#include <algorithm>

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

// Refuses a camera that would be under the ground in some frame.
void place_all(const Sequence& sequence, const Job& job) {
    const auto land = job.land.drawn();
    for (const SequenceFrame& frame : sequence.frames) {
        if (frame.scene) continue;  // it has a land of its own, which is not made yet
        try {
            render::place(frame.camera, *land, job.request.quality,
                          job.spec->render.water);
        } catch (const Error& error) {
            throw bad_request("{}: {}", frame.camera.name, error.what());
        }
    }
}

Json json_of(const SequencePlan& plan) {
    const Sequence& sequence = plan.sequence;
    Json shots = Json::array();
    for (const SequenceFrame& frame : sequence.frames) {
        Json told = {{"frame", frame.camera.name}};
        if (!frame.when.empty()) told["when"] = frame.when;
        if (frame.camera.sun) told["sun"] = json_of(*frame.camera.sun);
        if (frame.camera.turn != 0.0) told["turn"] = degrees(frame.camera.turn);
        shots.push_back(std::move(told));
    }
    const auto still = static_cast<std::size_t>(sequence.still);
    return {{"camera", sequence.camera},
            {"news", plan.messages},
            {"appears", plan.appears},
            {"key_frame", sequence.frames.at(still).camera.name},
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

// Adds what the frames of a film are made from. Other sequences follow from the scene.
void add_timeline(KeyBuilder& key, const Job& job) try {
    for (const SequenceFrame& frame : plan_of(Kind::kFilm, job).sequence.frames) {
        add_to(key, {.camera = frame.camera, .moments = frame.moments});
        if (frame.scene)
            key.add(job.land_of(frame.scene, job.progress).drawn_key())
                .add(frame.scene->render_text);
    }
} catch (const Error&) {
    key.add("nothing to film");  // check_plan() says why
}

// The key of everything that a plan and its frames are made from.
Key plan_key(const Job& job, Kind kind) {
    const render::ColourOptions& colour = job.spec->render.colour;
    const std::optional<std::array<int, 2>>& size = job.request.size;
    KeyBuilder key("plan");
    key.add(kind).add(job.request.frames ? job.request.frames->last : -1);
    key.add(job.program).add(job.land.key()).add(job.request.quality);
    key.add(job.request.preview).add(size ? (*size)[0] : 0).add(size ? (*size)[1] : 0);
    key.add(job.spec->title).add(job.spec->name);
    key.add(ocio_hash()).add(colour.config ? colour.config->hash : 0);
    key.add(job.spec->render_text).add(job.spec->frames_text);
    if (kind == Kind::kFilm) add_timeline(key, job);
    return key.key();
}

// Frames of different styles and ranges are recorded as different steps.
std::string frames_name(Kind kind, const Job& job) {
    std::string name = name_of(kind);
    if (job.request.preview) name += fmt::format(" {}", name_of(*job.request.preview));
    if (const auto& asked = job.request.frames)
        name += fmt::format(" {}-{}", asked->first, asked->last);
    return name;
}

std::string plan_id(Kind kind) { return "plan " + name_of(kind); }
std::string film_id(Kind kind, const Job& job) {
    return (job.request.trace_only ? "trace " : "film ") + frames_name(kind, job);
}
std::string video_id(Kind kind, const Job& job) {
    return "video " + frames_name(kind, job);
}

// All frames, because those that are not asked for now may exist already. Moments have
// names that no camera can have.
std::vector<std::string> files_of_frames(Kind kind, const Job& job) {
    std::vector<std::string> files;
    const int count = check_plan(kind, job);
    for (int i = 0; i < count; ++i) {
        const std::string name = frame_name(name_of(kind), i);
        if (job.request.preview) {
            files.push_back(file_of_look(name_of(kind), *job.request.preview, i));
        } else {
            for (const char* extension : {".exr", ".png"})
                files.push_back("frames/" + name + extension);
        }
    }
    return files;
}

// Warns if there is no ffmpeg: the frames are worth having without the video.
void look_for_ffmpeg(Progress& progress) try {
    render::ffmpeg_program();
} catch (const Error& error) {
    progress.warn(fmt::format("{}; the frames are made, the video is not", error.what()));
}

Step plan_step(Kind kind, const Job& job, std::vector<Need> needs) {
    const auto run = [&job, kind](Graph&) {
        const SequencePlan plan = plan_of(kind, job);
        place_all(plan.sequence, job);
        return StepResult{{}, json_of(plan)};
    };
    return {.id = plan_id(kind),
            .needs = std::move(needs),
            .memory = memory::of_export(job.cells()),
            .key = [&job, kind] { return plan_key(job, kind); },
            .run = run,
            .gate = [&job](const Json& plan) { tell(plan, job.progress); },
            .before = [&job, kind] { check_plan(kind, job); }};
}

Step film_step(Kind kind, const Job& job, std::vector<Need> needs) {
    const std::uint64_t pixels = most_pixels(job);
    const std::uint64_t memory =
        job.request.preview ? memory::of_passes(job.drawn_cells(), pixels)
                            : std::max(memory::of_emit(job.drawn_cells()),
                                       memory::of_trace(job.drawn_cells(), pixels));
    const auto run = [&job, kind](Graph& graph) {
        const Sequence sequence = plan_of(kind, job).sequence;
        return job.request.preview
                   ? film_by_embree(job, sequence, *job.request.preview, graph)
                   : film_by_povray(job, sequence, graph);
    };
    const auto before = [&job] {
        if (!job.request.preview) render::povray_program();
    };
    return {.id = film_id(kind, job),
            .needs = std::move(needs),
            .memory = memory,
            .key = [] { return KeyBuilder("film").key(); },
            .run = run,
            .before = before,
            .writes = [&job, kind] { return files_of_frames(kind, job); }};
}

Step video_step(Kind kind, const Job& job) {
    return {
        .id = video_id(kind, job),
        .needs = {{plan_id(kind), Use::kAll}, {film_id(kind, job), Use::kFiles}},
        .memory = memory::of_delivery(most_pixels(job)),
        .key = [] { return KeyBuilder("video").key(); },
        .run = [&job, kind](Graph&) { return encode(plan_of(kind, job).sequence, job); },
        .before = [&job] { look_for_ffmpeg(job.progress); },
        .writes = [&job, kind] { return files_of_reel(name_of(kind), job); }};
}

constexpr Kind kKinds[] = {Kind::kDay, Kind::kTurntable, Kind::kFilm};

}  // namespace

std::vector<Step> sequence_steps(const Job& job, const std::vector<Need>& land,
                                 const std::vector<Need>& checked) {
    std::vector<Step> steps;
    for (const Kind kind : kKinds) {
        std::vector<Need> drawn{{plan_id(kind), Use::kAll}};
        if (!job.request.preview) drawn.push_back({kAssetsStep, Use::kAll});
        steps.push_back(plan_step(kind, job, job.request.preview ? land : checked));
        steps.push_back(film_step(kind, job, std::move(drawn)));
        if (!job.request.frames) steps.push_back(video_step(kind, job));
    }
    return steps;
}

std::vector<std::string> sequence_targets(Kind kind, const Job& job) {
    std::vector<std::string> ids{plan_id(kind), film_id(kind, job)};
    if (!job.request.frames) ids.push_back(video_id(kind, job));
    return ids;
}

}  // namespace cydonia
