#include "render/scene/things.h"

namespace cydonia::render {
namespace {

// A copy takes about two kilobytes of memory in POV-Ray.
std::size_t most_copies(Quality quality) {
    switch (quality) {
        case Quality::kDraft:
            return 10'000;
        case Quality::kPreview:
            return 60'000;
        case Quality::kFinal:
            break;
    }
    return 200'000;
}

}  // namespace

std::vector<std::vector<Thing>> things_of(const Shot& shot, const Terrain& terrain) {
    const std::vector<ThingOptions>& kinds = shot.options.things;
    std::vector<std::vector<Thing>> all;
    for (int i = 0; i < int(kinds.size()); ++i)
        all.push_back(things_in_view(terrain, kinds[std::size_t(i)], i, shot.camera,
                                     most_copies(shot.quality) / kinds.size(),
                                     shot.options.water));
    return all;
}

}  // namespace cydonia::render
