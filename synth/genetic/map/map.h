#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "synth/context.h"
#include "synth/genetic/options.h"

namespace cydonia::genetic {

// A map rasterised to a terrain's samples (sections IV.3.3.2 and V.3.3.6).
struct MapRaster {
    Field<std::uint8_t> types;  // index in the library
    Field<int> regions;         // index in `all`
    Field<float> distances;     // metres to the nearest boundary between types
    struct Found {
        std::string name = {};
        int type = 0;
        std::size_t cells = 0;
        std::array<int, 4> box{};     // first column and row, last column and row
        std::array<int, 2> inside{};  // column and row of one of its cells
    };
    // The connected components of land of one type. Neighbouring drawn regions of the
    // same type are one, a drawn region that covers no cell is none, and one that falls
    // apart is several; `progress` says so.
    std::vector<Found> all;
};

// Rasterises a map. Gaps go to the nearest region; where regions overlap, the later one
// lies on top; bands of transitional types are put between neighbours. `progress` says
// how much land is in gaps and overlaps. Throws bad_request for a map without regions,
// unknown types and outlines that cannot be used.
MapRaster rasterised(const MapOptions& map, const LibraryOptions& library,
                     const Extent& extent, std::uint64_t seed, Progress& progress);

// Makes up a plausible map (section VII.3): evenly spaced regions, with types whose mean
// heights are near their neighbours'. `means` are the types' mean heights in metres;
// types with NaN are not used.
MapOptions automatic_map(const LibraryOptions& library, const std::vector<double>& means,
                         int regions, const Extent& extent, std::uint64_t seed);

}  // namespace cydonia::genetic
