#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "field/field.h"
#include "field/image.h"
#include "field/sun.h"

namespace cydonia {

// What a terrain promises: under `sun` its shadows show `target`.
struct ShadowImage {
    std::string name;            // a file-name-safe word: "text"
    Field<std::uint8_t> target;  // same shape as the heights; 1 in shadow, 0 lit
    Sun sun;
    double min_iou = 0.85;  // the check fails below
    // A mask of the same shape: 1 where the target counts, and empty when it counts
    // everywhere. Outside, the land keeps its own shadows.
    Field<std::uint8_t> window = {};
    // A mask of the same shape: 1 where the target was relaxed because other images
    // contradict it; empty when it was relaxed nowhere.
    Field<std::uint8_t> relaxed = {};
};

// Stands in Terrain::water where there is no water.
inline constexpr float kDry = -std::numeric_limits<float>::infinity();

// Land: square cells, samples at cell centres, so that N samples span N cells.
struct Terrain {
    Field<float> heights;  // metres
    double spacing = 1.0;  // metres from a sample to the next; the size of a cell
    std::map<std::string, Field<float>> masks;  // 0 to 1, same shape as the heights
    std::vector<ShadowImage> shadows;
    // The height of the water's surface in metres, kDry where there is none; empty when
    // the land has no water. Under water `heights` is the bed.
    Field<float> water;
    // Figures that stages measured of their own work, for the manifest, each with its
    // name and unit; and pictures of any size, which are written beside the masks.
    std::map<std::string, double> figures = {};
    std::map<std::string, Field<Rgb8>> pictures = {};

    double width() const { return spacing * heights.width(); }   // west to east, metres
    double depth() const { return spacing * heights.height(); }  // south to north, metres
};

// The depth of the water over a sample in metres; 0 where the land is dry.
inline float water_depth(const Terrain& terrain, std::size_t sample) {
    if (terrain.water.empty()) return 0.0f;
    return std::max(0.0f, terrain.water[sample] - terrain.heights[sample]);
}
inline Field<float> water_depths(const Terrain& terrain) {
    Field<float> depths(terrain.heights.width(), terrain.heights.height());
    for (std::size_t i = 0; i < depths.size(); ++i) depths[i] = water_depth(terrain, i);
    return depths;
}

}  // namespace cydonia
