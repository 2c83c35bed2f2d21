// Rusnell 2009, sections 5.3.2 and 5.4.
#include "synth/pareidolia/holes.h"

#include "field/random.h"
#include "synth/pareidolia/shadow_plan.h"

namespace cydonia::pareidolia {
namespace {

// On every 256 x 256 nodes (docs/papers.md, Rusnell 12); points outside holes are not
// used.
constexpr std::uint64_t kPoints = 16384;

}  // namespace

Field<std::uint8_t> filled_shadows(const RegionTree& tree) {
    Field<std::uint8_t> filled(tree.region_at.width(), tree.region_at.height());
    for (std::size_t i = 0; i < filled.size(); ++i) filled[i] = tree.depth_at(i) > 0;
    return filled;
}

Field<float> hole_points(const Field<float>& holes, std::uint64_t seed) {
    Field<float> points(holes.width(), holes.height(), kNowhere);
    for (std::uint64_t i = 0; i < kPoints; ++i) {
        const auto cell = [&](std::uint64_t axis, int cells) {
            return static_cast<int>(unit(hash_of({seed, key("hole"), i, axis})) * cells);
        };
        const int x = cell(0, holes.width()), y = cell(1, holes.height());
        points(x, y) = holes(x, y);
    }
    return points;
}

}  // namespace cydonia::pareidolia
