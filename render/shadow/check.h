#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "field/progress.h"
#include "field/terrain.h"
#include "render/shadow/score.h"

namespace cydonia::render {

inline constexpr int kCheckRays = 2;  // samples a cell side behind every IoU we state

struct ShadowReport {
    std::string name;
    Sun sun;
    double min_iou = 0.0;
    ShadowScore score;
    bool passed() const { return score.iou >= min_iou; }
};

// Casts every shadow image of the terrain and writes cast.png, target.png and overlay.png
// (hit, missed, spurious) into `folder` (`folder/<name>/` where there are several).
std::vector<ShadowReport> check(const Terrain& terrain,
                                const std::filesystem::path& folder, Progress& progress);

// What to change in the scene when the image falls short, in a few sentences.
std::string advice(const ShadowReport& report);

}  // namespace cydonia::render
