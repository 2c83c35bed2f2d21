// Rusnell 2009, section 5.3, steps 3, 5 and 6 of Algorithm 4, and section 5.3.1.
#include "synth/pareidolia/shadow_plan.h"

#include <algorithm>
#include <cmath>

#include "field/sample.h"

namespace cydonia::pareidolia {
namespace {

// The shares of the height between a line of light and the ground by which relief stays
// below the line. The least is above 0, because light would otherwise graze the ground.
constexpr double kLeastRelief = 0.05, kRelief = 0.5;
// A crest takes the cells at these distances in front of the shadow. There are two,
// because an oblique crest on a single line of cells has gaps; they keep off the border
// itself, where rounding would make teeth.
constexpr double kCrest[] = {0.3, 1.0};

}  // namespace

ShadowPlan shadow_plan(const ShadowImage& image, double spacing) {
    constexpr int kDensity = 4;
    const LightFrame frame = light_frame(image.target.width(), image.target.height(),
                                         image.sun.azimuth, kDensity);
    return {&image.target, std::tan(image.sun.elevation) * spacing, frame,
            runs_of(rotated(image.target, frame))};
}

std::vector<float> crest_heights(const ShadowPlan& plan, const Field<float>& ground) {
    std::vector<float> crests;
    crests.reserve(plan.runs.size());
    for (const Run& run : plan.runs) {
        const double over = plan.rise * plan.length(run);
        const GridPoint end = plan.end(run);
        crests.push_back(bilinear(ground, end.x, end.y) + static_cast<float>(over));
    }
    return crests;
}

Field<float> primary_features(const ShadowPlan& plan, const std::vector<float>& crests) {
    Field<float> heights(plan.width(), plan.height(), kNowhere);
    for (std::size_t i = 0; i < crests.size(); ++i) {
        const GridPoint start = plan.start(plan.runs[i]);
        for (double before : kCrest) {
            const Cell c = cell_of({start.x - before * plan.frame.along.x,
                                    start.y - before * plan.frame.along.y});
            if (heights.contains(c.x, c.y))
                heights(c.x, c.y) = std::max(heights(c.x, c.y), crests[i]);
        }
    }
    return heights;
}

Field<float> shadow_ends(const ShadowPlan& plan, const Field<float>& ground) {
    Field<float> heights(plan.width(), plan.height(), kNowhere);
    for (const Run& run : plan.runs) {
        const Cell c = cell_of(plan.end(run));
        if (heights.contains(c.x, c.y)) heights(c.x, c.y) = ground(c.x, c.y);
    }
    return heights;
}

Field<float> shadow_ceiling(const ShadowPlan& plan, const std::vector<float>& crests,
                            const Field<float>& relief) {
    Field<float> ceiling(plan.width(), plan.height(), -kNowhere);
    for (std::size_t i = 0; i < crests.size(); ++i) {
        const double length = plan.length(plan.runs[i]);
        each_cell(plan, plan.runs[i], [&](Cell c, double behind) {
            const double room = std::max(0.0, std::min(behind, length - behind));
            const double below =
                kLeastRelief + (kRelief - kLeastRelief) * relief(c.x, c.y);
            const double drop = behind + below * room;
            const float height = crests[i] - static_cast<float>(plan.rise * drop);
            ceiling(c.x, c.y) = std::min(ceiling(c.x, c.y), height);
        });
    }
    return ceiling;
}

}  // namespace cydonia::pareidolia
