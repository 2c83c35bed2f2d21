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

// What a command line asks for.
struct Request {
    std::filesystem::path scene;
    std::filesystem::path output;        // empty: out/<scene's name>
    std::vector<std::string> overrides;  // "terrain.samples=1024"
    render::Quality quality = render::Quality::kPreview;
    int threads = 0;  // 0: as many as the machine has
    bool quiet = false;
    bool force = false;    // go on when the shadow check falls short
    bool dry_run = false;  // print the plan, do nothing
    bool first_camera_only = false;
    // Width and height of every frame, pixels; none: those of its camera, by quality.
    std::optional<std::array<int, 2>> size = {};
    // Only these frames of a sequence, without the video; none: all.
    struct Frames {
        int first = 0, last = 0;  // from 0, both included
    };
    std::optional<Frames> frames = {};
    // Only trace these frames, while other processes trace others in the same folder.
    bool trace_only = false;
    // Frames in this style by Embree, instead of by POV-Ray.
    std::optional<render::Style> preview = {};
    bool explain = false;                         // stages show how they made their land
    std::optional<ExportRequest> export_as = {};  // also write this file
    // Only this tile of a land in tiles: column from the west, row from the north.
    std::optional<std::array<int, 2>> tile = {};
};

// What a command makes: a set of steps, given by targets_of().
enum class Goal { kTerrain, kCheck, kReport, kEmit, kFrames, kSweep, kTurntable, kFilm };

std::string_view name_of(Goal goal);  // of the command

}  // namespace cydonia
