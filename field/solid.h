#pragma once

#include "field/mesh.h"
#include "field/terrain.h"
#include "field/vec.h"

namespace cydonia {

// Options of a terrain as a solid to hold in the hand, in millimetres.
struct SolidOptions {
    double size = 150.0;   // its longer side; 1 to 10000
    double base = 3.0;     // of plate under the lowest ground; 0.1 to 1000
    double scale_z = 1.0;  // heights times this; 0.01 to 100
    int samples = 512;     // at most, along the longer side; 2 to 2048
};

inline constexpr int kMostSolidSamples = 2048;  // 8.4 million triangles

struct Solid {
    Mesh mesh;  // its lowest south-western corner is the origin
    Vec3 size;  // millimetres
    double millimetres_a_metre;
    int width, height;  // samples of its surface
};

// Throws bad_request when a value is out of its range or not a number.
void expect_in_range(const SolidOptions& options);

// A closed solid with the mesh that is rendered on top (16-bit heights at the cells'
// centres, squares split NW-SE), vertical walls around it and a flat plate below. Land of
// more samples is averaged down first; where there is water, the bed is the surface.
// Every edge lies in two triangles. Throws bad_request for options out of range and for a
// solid higher than 10 m.
Solid solid_of(const Terrain& terrain, const SolidOptions& options);

// The sun under which the solid casts the same shadows: heights times scale_z need a sun
// whose elevation has a tangent scale_z times as large.
Sun lamp_for(const Sun& sun, const SolidOptions& options);

}  // namespace cydonia
