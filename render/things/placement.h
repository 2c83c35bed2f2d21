#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "field/camera.h"
#include "field/terrain.h"
#include "render/ground/options.h"
#include "render/things/options.h"

namespace cydonia::render {

// A copy of an original on the land.
struct Thing {
    Vec3 foot;            // world metres; the original's origin
    float height = 1.0f;  // metres
    float turn = 0.0f;    // about the vertical, radians
    std::uint8_t original = 0;
};

// The things of one kind that a camera sees or that may cast shadows into its frame, at
// most `most`; the nearest and largest are kept. Their positions are hashes of the
// lattice square and of `number`, the kind's index in the scene, so that a moving camera
// sees the same things. None stands under water, including `flood`.
std::vector<Thing> things_in_view(const Terrain& terrain, const ThingOptions& options,
                                  int number, const Camera& camera, std::size_t most,
                                  const std::optional<WaterOptions>& flood = {});

}  // namespace cydonia::render
