#include "app/pipeline/steps.h"

#include <algorithm>

#include "app/export/export.h"
#include "app/pipeline/report_step.h"
#include "app/pipeline/tiles.h"
#include "app/sequence/plan.h"
#include "app/sequence/steps.h"

namespace cydonia {
namespace {

std::string finished_land_id(const Job& job) { return stage_id(job, job.land.stages()); }

// The land that the other steps start from. Without stages it is flat and needs no step.
std::vector<Need> finished_land(const Job& job) {
    if (job.land.stages() == 0) return {};
    return {{finished_land_id(job), Use::kDone}};
}

// POV-Ray draws a land only after the check, so that nothing is traced if it falls short.
std::vector<Need> checked_land(const Job& job) {
    std::vector<Need> needs = finished_land(job);
    needs.push_back({kCheckStep, Use::kDone});
    return needs;
}

std::vector<Need> all_shown(const std::vector<Step>& steps) {
    std::vector<Need> needs;
    for (const Step& step : steps) needs.push_back({step.id, Use::kShown});
    return needs;
}

// Steps with their needs, in the order in which they are done.
struct Table {
    std::vector<Step> steps;

    void add(Step step, std::vector<Need> needs) {
        step.needs = std::move(needs);
        steps.push_back(std::move(step));
    }
    void add(std::vector<Step> more) {
        std::ranges::move(more, std::back_inserter(steps));
    }
};

// A trace is expensive, so it depends on the bytes of the emitted files alone.
void add_trace(Table& table, const Job& job, const Frame& frame) {
    table.add(trace_step(job, frame),
              {{kAssetsStep, Use::kFiles}, {emit_id(frame.camera.name), Use::kFiles}});
}

// A delivery is cheap: another exposure or view needs no new trace.
void add_delivery(Table& table, const Job& job, const Frame& frame) {
    const std::string& name = frame.camera.name;
    table.add(deliver_step(job, frame), {{trace_id(name), Use::kFiles}});
    if (job.spec->render.passes)
        table.add(passes_step(job, frame), {{deliver_id(name), Use::kFiles}});
}

// Previews by Embree need nothing but the land itself.
std::vector<std::string> land_targets(const Job& job) {
    if (job.request.preview) {
        if (job.land.stages() == 0) return {};
        return {finished_land_id(job)};
    }
    std::vector<std::string> ids{kExportStep};
    if (job.request.export_as) ids.push_back(export_file_id(job));
    return ids;
}

std::vector<std::string> emit_targets(const Job& job) {
    std::vector<std::string> ids{kAssetsStep};
    for (const auto& camera : job.cameras()) ids.push_back(emit_id(camera.name));
    return ids;
}

std::vector<std::string> still_targets(const Job& job) {
    std::vector<std::string> ids;
    for (const auto& camera : job.cameras()) {
        ids.push_back(deliver_id(camera.name));
        if (job.spec->render.passes) ids.push_back(passes_id(camera.name));
    }
    return ids;
}

std::vector<std::string> preview_targets(const Job& job) {
    std::vector<std::string> ids;
    for (const auto& camera : job.cameras()) ids.push_back(preview_id(job, camera.name));
    return ids;
}

}  // namespace

std::vector<Step> steps_of(const Job& job) {
    if (job.spec->terrain.tiles > 0) return {tiles_step(job)};
    const std::vector<Frame> stills = stills_of(job);
    Table table;
    for (int stage = 1; stage <= job.land.stages(); ++stage) {
        std::vector<Need> needs;
        if (stage > 1) needs = {{stage_id(job, stage - 1), Use::kDone}};
        if (job.request.explain) {
            table.add(explain_step(job, stage), needs);
            needs = {{explain_id(job, stage), Use::kDone}};
        }
        table.add(stage_step(job, stage), needs);
    }
    table.add(export_step(job), finished_land(job));
    if (job.request.export_as) table.add(export_file_step(job), finished_land(job));
    table.add(check_step(job), finished_land(job));
    table.add(assets_step(job), checked_land(job));
    // All cameras are emitted first: one that cannot be placed fails before any trace.
    for (const Frame& still : stills)
        table.add(emit_step(job, still), {{kAssetsStep, Use::kAll}});
    for (const Frame& still : stills) {
        add_trace(table, job, still);
        add_delivery(table, job, still);
    }
    for (Step& step : preview_steps(job)) table.add(std::move(step), finished_land(job));
    table.add(sequence_steps(job, finished_land(job), checked_land(job)));
    table.add(report_step(job), all_shown(table.steps));
    return std::move(table.steps);
}

std::vector<Step> frame_steps(const Job& job, const Frame& frame) {
    Table table;
    if (frame.land.is_temporary) {
        table.add(trace_temporary_land_step(job, frame), {});
    } else {
        table.add(emit_step(job, frame), {{kAssetsStep, Use::kAll}});
        add_trace(table, job, frame);
    }
    add_delivery(table, job, frame);
    return std::move(table.steps);
}

std::vector<std::string> targets_of(Goal goal, const Job& job) {
    if (job.spec->terrain.tiles > 0) {
        if (goal != Goal::kTerrain) return {};
        return {kExportStep};
    }
    std::vector<std::string> ids = land_targets(job);
    const auto add = [&ids](std::vector<std::string> more) {
        std::ranges::move(more, std::back_inserter(ids));
    };
    if (goal == Goal::kTerrain) return ids;
    if (!job.request.preview) add({kCheckStep});
    if (goal == Goal::kCheck) return ids;
    if (goal == Goal::kEmit) add(emit_targets(job));
    if (goal == Goal::kFrames)
        add(job.request.preview ? preview_targets(job) : still_targets(job));
    if (const auto kind = sequence_of(goal)) add(sequence_targets(*kind, job));
    // A process that shares the folder makes no report, which shows the work of all.
    if (!job.request.trace_only) add({kReportStep});
    return ids;
}

std::vector<std::string> names_taken(Goal goal, const Job& job) {
    std::vector<std::string> ids = targets_of(goal, job);
    if (sequence_of(goal)) std::ranges::move(still_targets(job), std::back_inserter(ids));
    return ids;
}

}  // namespace cydonia
