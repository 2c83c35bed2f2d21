#include "synth/texture/database/candidates.h"

#include <algorithm>
#include <utility>

#include "field/random.h"

namespace cydonia::texture {
namespace {

float squared_distance(const Traits& a, const Traits& b) {
    float sum = 0.0f;
    for (std::size_t k = 0; k < kTraits; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

}  // namespace

void try_all(BestMatch& best, const LevelArrays& level, std::span<const int> turns) {
    for (int e = 0; e < static_cast<int>(level.sheets.size()); ++e) {
        const Sheet& sheet = level.sheets[std::size_t(e)];
        for (int y = 1; y < sheet.height - 1; ++y)
            for (int x = 1; x < sheet.width - 1; ++x)
                for (int o : turns) best.consider(e, x, y, o);
    }
}

void try_similar(BestMatch& best, int orientation, const TraitSpace& space,
                 const KdTree& tree) {
    const Traits traits = space.traits_of(best.wanted(orientation));
    const Sample *nearest = nullptr, *second = nullptr;
    float least = kNoMatch, less = kNoMatch;
    for (const Sample& sample : tree.around(traits)) {
        const float distance = squared_distance(sample.traits, traits);
        if (distance >= less) continue;
        if (!best.allowed(int(sample.exemplar), sample.x, sample.y)) continue;
        if (distance < least) {
            second = std::exchange(nearest, &sample);
            less = std::exchange(least, distance);
        } else {
            second = &sample;
            less = distance;
        }
    }
    for (const Sample* s : {nearest, second})
        if (s) best.consider(int(s->exemplar), s->x, s->y, orientation);
}

void try_coarser(BestMatch& best, const LevelArrays& coarser) {
    const Sheet& sheet = coarser.sheets[std::size_t(best.exemplar)];
    const int x = std::min(best.x / 2, sheet.width - 1);
    const int y = std::min(best.y / 2, sheet.height - 1);
    const Match& m = coarser.matches[sheet.index(x, y)];
    const Step from_middle =  // in halves of a cell
        turned(m.orientation, {2 * (best.x - 2 * x) - 1, 2 * (best.y - 2 * y) - 1});
    best.consider(m.exemplar, 2 * m.x + (from_middle.x + 1) / 2,
                  2 * m.y + (from_middle.y + 1) / 2, m.orientation);
}

void try_beside(BestMatch& best, Step towards, const Match& neighbours) {
    const Step back = turned(neighbours.orientation, {-towards.x, -towards.y});
    best.consider(neighbours.exemplar, neighbours.x + back.x, neighbours.y + back.y,
                  neighbours.orientation);
}

void try_around(BestMatch& best, int pass) {
    int draw = 0;
    for (int radius : {8, 2, 1}) {
        const std::uint64_t h =
            hash_of({key("around"), std::uint64_t(best.exemplar), std::uint64_t(best.x),
                     std::uint64_t(best.y), std::uint64_t(16 * pass + draw++)});
        const int span = 2 * radius + 1;
        const int dx = static_cast<int>((h >> 8 & 0xffff) % span) - radius;
        const int dy = static_cast<int>((h >> 24 & 0xffff) % span) - radius;
        const Match m = best.match();
        best.consider(m.exemplar, m.x + dx, m.y + dy, m.orientation);
    }
}

}  // namespace cydonia::texture
