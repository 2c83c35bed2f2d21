#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"
#include "field/image.h"
#include "field/terrain.h"

namespace cydonia::render {

// A surface as vertex attributes of glTF: metres, y up, north at -z, the land's
// south-western corner at the origin. Texture coordinates run from 0 to 1 over the land,
// from its north-western corner.
struct SurfaceMesh {
    std::vector<float> positions, normals, tangents, places;  // 3, 3, 4 and 2 a vertex
    std::vector<std::uint32_t> indices;
};

// The mesh through at least 2 x 2 heights at the centres of the cells of a land of
// width x depth metres. Its squares are split NW-SE.
SurfaceMesh surface_mesh(const Field<float>& heights, double width, double depth);

// The surface of the water over the same grid; empty when no sample is wet.
SurfaceMesh water_mesh(const Terrain& terrain, double width, double depth);

// A tangent-space normal map (glTF section 3.9.3) of the detail in `fine` that the mesh
// through `coarse` lacks. Both cover the same land. The map has one pixel for each height
// of `fine`, row 0 in the north.
Field<Rgb8> normal_map(const Field<float>& fine, const Field<float>& coarse, double width,
                       double depth);

}  // namespace cydonia::render
