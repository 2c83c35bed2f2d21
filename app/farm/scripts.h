#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/request.h"

namespace cydonia {

// What a farm is to do, and the limits of its jobs.
struct FarmPlan {
    std::filesystem::path program,
        folder;        // absolute: this program, and where it was run
    Request request;   // scene and output are absolute paths
    std::string name;  // of the scene: letters, digits, - and _
    Goal goal = Goal::kTurntable;
    std::vector<Request::Frames> chunks;  // frames of each task; empty if all are traced
    bool land = true;                     // the land has to be made
    int minutes = 60;                     // time limit of a task
    std::uint64_t land_memory = 0, frame_memory = 0, collect_memory = 0;  // bytes
};

// The script of a job, for sbatch.
struct Script {
    std::string file;  // "land.sh"
    std::string text;
};

// The land, an array of frames, and the videos with the report. Each job waits for the
// one before it.
std::vector<Script> scripts_of(const FarmPlan& plan);

// Quoted for a shell, so that it is one word.
std::string quoted(const std::string& word);

}  // namespace cydonia
