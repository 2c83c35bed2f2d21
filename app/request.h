#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/export/request.h"
#include "render/embree/style.h"
#include "render/options.h"

namespace cydonia {

// What the command line asks for.
struct Request {
    std::filesystem::path scene;
    std::filesystem::path output;        // empty: out/<scene's name>
    std::vector<std::string> overrides;  // "terrain.samples=1024"
    render::Quality quality = render::Quality::kPreview;
    int threads = 0;  // 0: all the machine has
    bool quiet = false;
    bool force = false;    // goes on after a check that fell short
    bool dry_run = false;  // prints the plan only
    bool first_camera_only = false;
    // Pixels of every frame; empty: its camera's, by quality.
    std::optional<std::array<int, 2>> size = {};
    // Only these frames of a sequence; empty: all, and the video.
    struct Frames {
        int first = 0, last = 0;  // from 0, both included
    };
    std::optional<Frames> frames = {};
    // Of those only the light, by POV-Ray, while others of the folder's frames are traced
    // by other processes.
    bool trace_only = false;
    // Frames by Embree, shown so, instead of by POV-Ray.
    std::optional<render::Style> preview = {};
    bool explain = false;  // stages show how they came to their land
    std::optional<ExportRequest> export_as = {};  // besides
    // Of a land in tiles only this one: column from the west, row from the north.
    std::optional<std::array<int, 2>> tile = {};
};

// How far to go; each goal includes those before it, but what films frames of its own
// leaves the stills and one another alone. Assets are what all frames draw.
enum class Goal {
    kTerrain,
    kCheck,
    kReport,
    kAssets,
    kEmit,
    kFrames,
    kSweep,
    kTurntable,
    kFilm
};

std::string_view name_of(Goal goal);  // the command that reaches it

}  // namespace cydonia
