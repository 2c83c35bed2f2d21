#pragma once

#include <string>
#include <vector>

#include "synth/distance/site.h"

namespace cydonia::distance {

// A group whose features are placed.
struct PlacedGroup {
    std::string name;
    std::vector<Shape> shapes;
    double highest_cost() const;
};

// The group of that name among those before; throws bad_request, with `asked` saying who
// asked ("group 'hills': away.from").
const PlacedGroup& group_before(const std::vector<PlacedGroup>& before,
                                const std::string& name, const std::string& asked);

// Random places for the features of group `name`. The k-th try of the i-th is a hash of
// the seed, the name, i and k, so that what happens to other groups moves none of them.
// Throws bad_request when there is no room.
std::vector<SitePoint> random_places(const Placement& placement, const std::string& name,
                                     const Site& site,
                                     const std::vector<PlacedGroup>& before);

}  // namespace cydonia::distance
