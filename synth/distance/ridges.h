#pragma once

#include <span>
#include <vector>

#include "synth/distance/dijkstra.h"
#include "synth/distance/places.h"
#include "synth/distance/site.h"

namespace cydonia::distance {

// Rusnell 2009, sections 4.1 and 5.4: traces least-cost paths from random nodes back to
// the features of the groups that `ridges` names (by default the last of `groups`), and
// adds the paths to those features. Throws bad_request when no node can be found.
void grow_ridges(const Ridges& ridges, std::vector<PlacedGroup>& groups,
                 const Site& site);

// The generators of some groups as starts at the nodes of `graph`.
struct Origins {
    std::vector<Start> starts;
    struct Origin {
        int group, shape, place;
    };
    std::vector<Origin> of;  // each start
};
Origins origins_of(std::span<const int> which, const std::vector<PlacedGroup>& groups,
                   const Graph& graph);

}  // namespace cydonia::distance
