#include "render/scene/land_maps.h"

#include <algorithm>
#include <cmath>

namespace cydonia::render {
namespace {

constexpr int kLongestGround = 4096;  // pixels a side

// Pixels a sample. A draft needs fewer because its frame is a third as large.
int ground_detail(const Field<float>& heights, Quality quality) {
    const int longest = std::max(heights.width(), heights.height());
    return std::clamp(kLongestGround / longest, 1, quality == Quality::kDraft ? 2 : 4);
}

}  // namespace

LandMaps land_maps(const Terrain& terrain, const GroundOptions& ground, Quality quality) {
    LandMaps maps{ground_map(terrain, ground, ground_detail(terrain.heights, quality)),
                  sky_visibility(terrain.heights, terrain.spacing)};
    for (float& share : maps.sky_visibility)
        share = std::round(65535.0f * std::clamp(share, 0.0f, 1.0f)) / 65535.0f;
    return maps;
}

}  // namespace cydonia::render
