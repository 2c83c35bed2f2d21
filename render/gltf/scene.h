#pragma once

#include <array>
#include <string>
#include <vector>

#include "field/terrain.h"
#include "render/scene/shot.h"

namespace cydonia::render {

// A scene as a file for other 3D programs.
struct GltfScene {
    std::string file;                    // of a .glb
    std::array<int, 2> samples;          // of the mesh
    std::array<int, 2> colour, normals;  // pixels of the textures
    std::size_t triangles = 0;           // of the land
    double lux = 0.0;                    // illuminance by the sun on a surface facing it
};

inline constexpr int kMostGltfSamples = 2048;  // a side: 8.4 million triangles

// Writes glTF 2.0 in one file: metres, y up, north at -z, the land's south-western corner
// at the origin. It holds the land as drawn, averaged to at most `samples` along the
// longer side (2 to kMostGltfSamples), with baked colours and a normal map of the detail
// that the mesh lacks; seas and lakes; the first shot's sun as a directional light
// (KHR_lights_punctual); and a camera for every shot, under its name. Needs at least one
// shot.
GltfScene gltf_scene(const Terrain& terrain, const std::vector<Shot>& shots, int samples);

}  // namespace cydonia::render
