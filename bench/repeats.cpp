#include "bench/repeats.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "synth/texture/synthesis/origins.h"

namespace cydonia::bench {

namespace {

using texture::Origin;
using texture::Spot;
using texture::Step;

constexpr int kAbout = 8;  // cells: a block that lies this far off is not another one

// Where a cell says that the block it is from has its middle on the land, and how that
// block is turned.
struct Sight {
    std::uint64_t block;  // its exemplar and place there
    int orientation, x, y;
    auto operator<=>(const Sight&) const = default;
};

Step turned_back(int orientation, Step step) {
    for (int o = 0; o < 8; ++o)
        if (texture::composed(orientation, o) == 0) return texture::turned(o, step);
    return step;
}

Sight sight(Origin place, int x, int y, int side) {
    const Spot spot = texture::spot_of(place);
    const int column = spot.x / 2, row = spot.y / 2;
    const Step to_middle{column / side * side + side / 2 - column,
                         row / side * side + side / 2 - row};
    const Step there = turned_back(spot.orientation, to_middle);
    const auto rounded = [](int v) { return (v + kAbout / 2) & ~(kAbout - 1); };
    return {static_cast<std::uint64_t>(spot.exemplar) << 48 |
                static_cast<std::uint64_t>(row / side) << 24 |
                static_cast<std::uint64_t>(column / side),
            spot.orientation, rounded(x + there.x), rounded(y + there.y)};
}

// Sorted by block.
std::vector<Sight> showings(const Field<Origin>& places, int side) {
    std::vector<Sight> sights;
    sights.reserve(places.size());
    for (int y = 0; y < places.height(); ++y)
        for (int x = 0; x < places.width(); ++x)
            sights.push_back(sight(places(x, y), x, y, side));
    std::ranges::sort(sights);
    std::vector<Sight> result;
    for (std::size_t i = 0, next; i < sights.size(); i = next) {
        for (next = i; next < sights.size() && sights[next] == sights[i];) ++next;
        if (2 * static_cast<int>(next - i) >= side * side) result.push_back(sights[i]);
    }
    return result;
}

double distance(const Sight& a, const Sight& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

Repeats repeats(const Field<Origin>& places, int side) {
    const std::vector<Sight> all = showings(places, side);
    Repeats result;
    int again = 0;
    for (std::size_t i = 0, next; i < all.size(); i = next) {
        std::vector<Sight> apart;  // what overlaps is one showing, a little stretched
        for (next = i; next < all.size() && all[next].block == all[i].block; ++next) {
            double nearest = HUGE_VAL;
            for (const Sight& other : apart)
                nearest = std::min(nearest, distance(all[next], other));
            if (nearest < side) continue;
            apart.push_back(all[next]);
            if (nearest < HUGE_VAL && (result.nearest == 0.0 || nearest < result.nearest))
                result.nearest = nearest;
        }
        const int count = static_cast<int>(apart.size());
        result.most = std::max(result.most, count);
        if (count > 1) again += count;
    }
    result.share =
        static_cast<double>(again) * side * side / static_cast<double>(places.size());
    return result;
}

}  // namespace cydonia::bench
