#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/request.h"

namespace cydonia {

// What is to be done on a farm, and what its jobs may take.
struct FarmPlan {
    std::filesystem::path program, folder;  // absolute: this one, and where it was run
    Request request;                        // scene and output are absolute paths
    std::string name;                       // of the scene: letters, digits, - and _
    Goal goal = Goal::kTurntable;
    std::vector<Request::Frames>
        chunks;        // frames of one task each; empty: all are traced
    bool land = true;  // is to be made
    int minutes = 60;  // of a task
    std::uint64_t land_memory = 0, frame_memory = 0, collect_memory = 0;  // bytes
};

// A job's script, for sbatch.
struct Script {
    std::string file;  // "land.sh"
    std::string text;
};

// In their order, each after the one before it: the land, an array of frames, and the
// videos and the report.
std::vector<Script> scripts_of(const FarmPlan& plan);

// For a shell: one word, whatever is in it.
std::string quoted(const std::string& word);

}  // namespace cydonia
