#pragma once

#include <string>
#include <vector>

#include "synth/distance/site.h"

namespace cydonia::distance {

// A group whose features have their places.
struct PlacedGroup {
    std::string name;
    std::vector<Shape> shapes;
    double highest_cost() const;
};

// The group of that name among those before. Throws bad_request whose message begins with
// `asked`, which says where the name stands ("group 'hills': away.from").
const PlacedGroup& group_before(const std::vector<PlacedGroup>& before,
                                const std::string& name, const std::string& asked);

// Random places for the features of group `name`. The k-th attempt for the i-th feature
// is a hash of the seed, the name, i and k, so that changes to other groups move no
// feature. Throws bad_request when there is not enough room.
std::vector<SitePoint> random_places(const Placement& placement, const std::string& name,
                                     const Site& site,
                                     const std::vector<PlacedGroup>& before);

}  // namespace cydonia::distance
