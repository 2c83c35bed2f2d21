#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "field/progress.h"
#include "field/terrain.h"
#include "render/shadow/figures.h"
#include "render/shadow/score.h"

namespace cydonia::render {

inline constexpr int kCheckRays = 2;  // samples a cell side behind every IoU we state
// An image that stands out less from other silhouettes is lost among the land's own
// shadows.
inline constexpr double kLeastStandingOut = 3.0;

struct ShadowReport {
    std::string name;
    Sun sun;
    double min_iou = 0.0;
    ShadowScore score;       // in the image's window
    double relaxed = 0.0;    // share of the window's cells that gave way to other images,
    std::string rival = {};  // mostly to this one
    std::optional<double> standing_out = {};  // where it was measured (figures.h)

    // Whether the image reads.
    bool passed() const;
};

// Casts every shadow image of the terrain and writes cast.png, target.png, overlay.png
// (overlay.h) and, where an image has a window, window.png (white: shadows count) into
// `folder` (`folder/<name>/` where there are several): a tenth of a second at 512 x 512.
// Throws
// bad_request where masks and heights differ in shape or heights are not numbers.
std::vector<ShadowReport> check(const Terrain& terrain,
                                const std::filesystem::path& folder);

// What takes longer: all figures of every image, in the reports' order, and sun-clock.png
// beside the others. `base` are the heights before the land was bent, null where they are
// not known.
std::vector<ShadowFigures> measure(const Terrain& terrain, const Field<float>* base,
                                   const std::filesystem::path& folder,
                                   Progress& progress);

// What to change in the scene when the image falls short, in a few sentences; empty where
// it reads.
std::string advice(const ShadowReport& report);

}  // namespace cydonia::render
