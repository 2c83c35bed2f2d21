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

// A map on a terrain's samples (sections IV.3.3.2 and V.3.3.6).
struct MapRaster {
    Field<std::uint8_t> types;  // index in the library
    Field<int> regions;         // index in `all`
    Field<float> distances;     // metres to the nearest boundary between types
    struct Found {
        std::string name;
        int type = 0;
        std::size_t cells = 0;
        std::array<int, 4> box{};     // west, north, east and south column and row
        std::array<int, 2> inside{};  // a cell of it
    };
    // Land of one type that hangs together. Neighbours of the same type are one, what
    // covers no cell is none, and what falls apart is several: `progress` is told.
    std::vector<Found> all;
};

// Gaps go to the nearest region; where regions overlap, the later one lies on top; bands
// of transitional types come between neighbours. `progress` is told how much of the land
// each is. Throws bad_request: no regions, unknown types, outlines that are none.
MapRaster rasterised(const MapOptions& map, const LibraryOptions& library,
                     const Extent& extent, std::uint64_t seed, Progress& progress);

// A plausible map (section VII.3): well-spaced regions, of types whose mean heights are
// near their neighbours'. `means` of the types, metres; NaN: not to be used.
MapOptions automatic_map(const LibraryOptions& library, const std::vector<double>& means,
                         int regions, const Extent& extent, std::uint64_t seed);

}  // namespace cydonia::genetic
