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

inline constexpr int kCheckRays = 2;  // samples a cell side, for every reported IoU
// An image that stands out from other silhouettes by less than this many standard
// deviations is lost among the land's own shadows.
inline constexpr double kLeastStandingOut = 3.0;

struct ShadowReport {
    std::string name;
    Sun sun;
    double min_iou = 0.0;
    ShadowScore score;     // within the image's window
    double relaxed = 0.0;  // share of the window's cells that were left to other images,
    std::string rival = {};                   // mostly to this one
    std::optional<double> standing_out = {};  // if it was measured (figures.h)

    // Whether the image can be recognised.
    bool passed() const;
};

// Casts every shadow image of the terrain and writes cast.png, target.png, overlay.png
// (overlay.h) and, if the image has a window, window.png (white where shadows count) into
// `folder`, or into `folder/<name>/` when there are several images. It takes a tenth of a
// second at 512 x 512.
// Throws
// bad_request when masks and heights differ in shape or heights are not numbers.
std::vector<ShadowReport> check(const Terrain& terrain,
                                const std::filesystem::path& folder);

// The slower part of the check: all figures of every image, in the order of the reports,
// and sun-clock.png beside the other pictures. `base` are the heights before the land was
// bent, or null when unknown.
std::vector<ShadowFigures> measure(const Terrain& terrain, const Field<float>* base,
                                   const std::filesystem::path& folder,
                                   Progress& progress);

// Advice on what to change in the scene when the image falls short, in a few sentences;
// empty when it does not.
std::string advice(const ShadowReport& report);

}  // namespace cydonia::render
