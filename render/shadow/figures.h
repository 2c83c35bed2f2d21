#pragma once

#include <optional>
#include <vector>

#include "field/terrain.h"
#include "render/shadow/caster.h"
#include "render/shadow/land_figures.h"
#include "render/shadow/score.h"

namespace cydonia::render {

// The land that is checked: heights rounded to POV-Ray's 16 bits, and their caster.
struct CheckedLand {
    // `heights` and `spacing` in metres. Throws bad_request as Caster does.
    CheckedLand(const Field<float>& heights, double spacing);

    Field<float> heights;
    double spacing;
    Caster caster;
};

// How visible an image is under one sun, measured over the whole frame.
struct Trace {
    double correlation = 0.0;   // of the cast shadow with the target; 0: invisible
    double outline = 1.0;       // outline_shading(); 1: invisible
    double standing_out = 0.0;  // from the distractors, in standard deviations
};

// A sun under which the image should not show: its own sun, turned or raised.
struct OtherSun {
    Sun sun;
    double turned = 0.0;  // radians from the image's own, clockwise; 0: raised
    Trace land;
    std::optional<Trace> base;

    // The correlation of the land minus that of the base.
    double correlation() const {
        return land.correlation - (base ? base->correlation : 0.0);
    }
};

// The cells of the window that an image left to others.
struct Relaxed {
    double share = 0.0;  // of the window
    double bound = 1.0;  // the highest IoU possible when all of them are wrong
};
Relaxed relaxed(const ShadowImage& image);

// All figures of one image. Its window is where shadows count.
struct ShadowFigures {
    // With hard shadows, within the window: at 2x2 and 4x4 samples a cell, and at the
    // middles of cells.
    ShadowScore fine;
    double iou_4x4 = 0.0, iou_1x1 = 0.0;
    double iou_frame = 0.0;  // 2x2, everywhere
    double iou_soft = 0.0;   // 2x2; in shadow where half of the sun's disc is occluded
    double outline = 0.0;    // F-score of the outlines at one cell, 2x2
    std::optional<double> thin_recall;  // of parts thinner than four cells
    Relaxed relaxed;

    double standing_out = 0.0;  // under its own sun
    std::vector<OtherSun> other_suns;

    LandFigures land;
    std::optional<LandFigures> base;
};

// Throws bad_request when the image's masks and the heights differ in shape.
void check_shapes(const Field<float>& heights, const ShadowImage& image);

// `base` is the land before it was bent, null where that is not known: what is less the
// base's is then left out. Throws bad_request where masks and heights differ in shape.
ShadowFigures shadow_figures(const CheckedLand& land, const CheckedLand* base,
                             const ShadowImage& image);

// How far the correlation is from the base's own, either way (a bright image shows as a
// dark one does), with the sun turned so many degrees, mean of both ways; 0: with the sun
// raised.
double hiddenness(const ShadowFigures& figures, double turned_degrees);
// Of the outlines at 90 degrees, mean of both ways.
double outline_ratio(const ShadowFigures& figures);
double outline_ratio_of_base(const ShadowFigures& figures);
// The most that the image stands out, dark or bright, under a sun turned by 30 degrees or
// more, or raised.
double worst_standing_out(const ShadowFigures& figures);

}  // namespace cydonia::render
