#pragma once

#include <string>
#include <vector>

#include "app/pipeline/frame.h"
#include "app/pipeline/graph.h"
#include "app/pipeline/job.h"
#include "app/request.h"

namespace cydonia {

// Everything that can be made of a scene, in the order in which it is done.
std::vector<Step> steps_of(const Job& job);

// The steps that a command is for. The steps that they need are done too.
std::vector<std::string> targets_of(Goal goal, const Job& job);
// The steps among which no two may write the same file: the targets, and for a sequence
// the stills too, whose files are in the same folders.
std::vector<std::string> names_taken(Goal goal, const Job& job);

// The steps of one frame with their needs, which include steps of the land: emit, trace,
// deliver, and passes if the scene asks for them. If the land is temporary, emit and
// trace are one step.
std::vector<Step> frame_steps(const Job& job, const Frame& frame);

// The ids of steps.
inline constexpr const char* kExportStep = "terrain";
inline constexpr const char* kCheckStep = "check";
inline constexpr const char* kAssetsStep = "emit land";
inline constexpr const char* kReportStep = "report";
std::string stage_id(const Job& job, int stage);
std::string explain_id(const Job& job, int stage);
std::string export_file_id(const Job& job);
std::string emit_id(const std::string& frame);
std::string trace_id(const std::string& frame);
std::string deliver_id(const std::string& frame);
std::string passes_id(const std::string& frame);
std::string preview_id(const Job& job, const std::string& frame);

// Each kind of step and the files it writes. steps_of() adds the needs.
Step stage_step(const Job& job,
                int stage);  // the land after one more stage, in the cache
Step explain_step(const Job& job, int stage);  // explain/: how the stage made its land
Step export_step(const Job& job);              // terrain.exr, terrain.tif, masks/
Step check_step(const Job& job);   // shadow/; its gate stops if one falls short
Step assets_step(const Job& job);  // pov/: what all frames draw
Step emit_step(const Job& job, const Frame& frame);     // pov/: what one frame draws
Step trace_step(const Job& job, const Frame& frame);    // pov/<frame>.exr, its light
Step deliver_step(const Job& job, const Frame& frame);  // frames/<frame>.exr and .png
Step passes_step(const Job& job, const Frame& frame);   // frames/<frame>.passes.exr
std::vector<Step> preview_steps(const Job& job);        // frames/<camera>.<style>.png

// Emits and traces a frame whose land is temporary.
Step trace_temporary_land_step(const Job& job, const Frame& frame);

std::uint64_t ocio_hash();  // of the config that $OCIO names; 0 if there is none

}  // namespace cydonia
