#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"
#include "field/image.h"
#include "field/terrain.h"

namespace cydonia::render {

// A surface as glTF's vertex attributes: metres, y up, north at -z, the land's
// south-western corner at the origin. Texture coordinates run over the land's whole
// extent from its north-western corner.
struct SurfaceMesh {
    std::vector<float> positions, normals, tangents, places;  // 3, 3, 4 and 2 a vertex
    std::vector<std::uint32_t> indices;
};

// The mesh through heights at the centres of the land's cells, width x depth metres
// wide; its squares are split NW-SE. At least 2 x 2 heights.
SurfaceMesh surface_mesh(const Field<float>& heights, double width, double depth);

// The water's surface over the same grid; empty where no sample is wet.
SurfaceMesh water_mesh(const Terrain& terrain, double width, double depth);

// What the mesh through `coarse` cannot show of `fine`, which covers the same land: a
// tangent-space normal map of glTF (section 3.9.3), a pixel a height of `fine`, row 0 in
// the north.
Field<Rgb8> normal_map(const Field<float>& fine, const Field<float>& coarse, double width,
                       double depth);

}  // namespace cydonia::render
