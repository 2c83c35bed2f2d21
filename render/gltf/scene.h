#pragma once

#include <array>
#include <string>
#include <vector>

#include "field/terrain.h"
#include "render/scene/shot.h"

namespace cydonia::render {

// A scene for other 3D programs.
struct GltfScene {
    std::string file;                    // of a .glb
    std::array<int, 2> samples;          // of the mesh
    std::array<int, 2> colour, normals;  // pixels of the textures
    std::size_t triangles = 0;           // of the land
    double lux = 0.0;                    // of the sun on what faces it
};

inline constexpr int kMostGltfSamples = 2048;  // a side: 8.4 million triangles

// glTF 2.0 in one file, in metres, y up and north at -z, the land's south-western corner
// at the origin: the land as it is drawn, averaged to at most `samples` along the longer
// side (2 to kMostGltfSamples), under its baked colours and a map of the normals that the
// mesh lost; seas and lakes; the first shot's sun as a directional light
// (KHR_lights_punctual); and a camera for every shot, by its name. At least one shot.
GltfScene gltf_scene(const Terrain& terrain, const std::vector<Shot>& shots, int samples);

}  // namespace cydonia::render
